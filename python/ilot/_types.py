# SPDX-License-Identifier: Apache-2.0
"""Types of arguments and results."""
import os

import numpy as np
from numpy.typing import NDArray

from . import _ilot

Path = str | os.PathLike[str]
Floats = NDArray[np.float64]
Singles = NDArray[np.float32]
Indices = NDArray[np.uint32]


def usage_fault(sentence: str) -> Exception:
    """An ilot.Error of code 2: what was asked for cannot be."""
    fault = _ilot.Error(sentence)
    fault.code = 2
    return fault
