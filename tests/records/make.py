"""Makes the small MAT files that the tests of the readers use. Needs NumPy and SciPy; the numbers are our own."""

import numpy as np
from scipy.io import savemat

t = np.arange(5) * 0.25
data = np.column_stack([t, np.array([0.0, 1.5, -2.0, 3.25, 0.125]), np.array([1.0, 2.0, 3.0, 4.0, 5.0])])
numbers = {
    "double": data,
    "single": data.astype(np.float32),
    "int8": np.array([[-128, 0, 127]], dtype=np.int8),
    "uint8": np.array([[0, 255]], dtype=np.uint8),
    "int16": np.array([[-32768], [32767]], dtype=np.int16),
    "uint16": np.array([[0, 65535]], dtype=np.uint16),
    "int32": np.array([[-2147483648, 2147483647]], dtype=np.int32),
}
wide = {
    "uint32": np.array([[0, 4294967295]], dtype=np.uint32),
    "int64": np.array([[-(2**53), 2**53]], dtype=np.int64),
    "uint64": np.array([[0, 2**53]], dtype=np.uint64),
}
others = {
    "text": "abc",
    "cell": np.array([1.0, "x"], dtype=object),
    "struct": {"a": 1.0},
    "complex": np.array([[1 + 2j]]),
    "cube": np.zeros((2, 2, 2)),
    "logical": np.array([[True, False]]),
    "empty": np.zeros((0, 0)),
}
savemat("level5.mat", {**numbers, **wide, **others}, do_compression=False)
savemat("level5_compressed.mat", {**numbers, **wide, **others}, do_compression=True)
savemat("level4.mat", {**{k: v for k, v in numbers.items() if k not in ("int8",)}, "text": "abc", "complex": np.array([[1 + 2j]])}, format="4")
savemat("run.mat", {"data": data.T, "other": t}, do_compression=True)

# the header's text holds the date and the machine: the same bytes on every run
for name in ("level5.mat", "level5_compressed.mat", "run.mat"):
    with open(name, "r+b") as f:
        f.write(b"MATLAB 5.0 MAT-file, made by make.py".ljust(116))
