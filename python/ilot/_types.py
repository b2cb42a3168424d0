# SPDX-License-Identifier: Apache-2.0
"""Types of arguments and results."""
import os

import numpy as np
from numpy.typing import NDArray

Path = str | os.PathLike[str]
Floats = NDArray[np.float64]
Singles = NDArray[np.float32]
Indices = NDArray[np.uint32]
