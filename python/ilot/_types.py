# SPDX-License-Identifier: Apache-2.0
"""Types of arguments and results. They stand in annotations alone, so that `import ilot` need not load NumPy: that would take more than
all else in it."""
from __future__ import annotations

import os
from typing import TYPE_CHECKING

from . import _ilot

Path = str | os.PathLike[str]
if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray
    Floats = NDArray[np.float64]
    Singles = NDArray[np.float32]
    Indices = NDArray[np.uint32]


def usage_fault(sentence: str) -> Exception:
    """An ilot.Error of code 2: what was asked for cannot be."""
    fault = _ilot.Error(sentence)
    fault.code = 2
    return fault
