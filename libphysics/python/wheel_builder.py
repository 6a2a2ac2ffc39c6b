# SPDX-License-Identifier: MIT
"""Makes a wheel of the folder libphysics: all that pip asks of a back end for a package that has nothing to compile."""
import base64
import hashlib
import re
import zipfile
from pathlib import Path

HERE = Path(__file__).resolve().parent


def _version():
    """The library's, which is written in the project's top folder; in a copy without it, that of this file."""
    top = HERE.parents[1] / "CMakeLists.txt"
    found = re.search(r"project\(physics VERSION ([0-9.]+)", top.read_text()) if top.is_file() else None
    return found[1] if found else "1.1.0"


def _metadata():
    return (f"Metadata-Version: 2.1\nName: libphysics\nVersion: {_version()}\n"
            "Summary: Physics steps for one rolling ball in a maze of boxes: libphysics for numpy\n"
            "License: MIT\nRequires-Python: >=3.9\nRequires-Dist: numpy>=1.21\n"
            "Description-Content-Type: text/markdown\n\n" + (HERE / "README.md").read_text())


def _record_line(name, data):
    digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
    return f"{name},sha256={digest},{len(data)}\n"


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    info = f"libphysics-{_version()}.dist-info"
    files = {f"libphysics/{file.name}": file.read_bytes() for file in sorted((HERE / "libphysics").iterdir())
             if file.suffix in (".py", ".typed")}
    files[f"{info}/METADATA"] = _metadata().encode()
    files[f"{info}/WHEEL"] = b"Wheel-Version: 1.0\nGenerator: wheel_builder\nRoot-Is-Purelib: true\nTag: py3-none-any\n"
    record = "".join(_record_line(name, data) for name, data in files.items()) + f"{info}/RECORD,,\n"
    files[f"{info}/RECORD"] = record.encode()
    name = f"libphysics-{_version()}-py3-none-any.whl"
    with zipfile.ZipFile(Path(wheel_directory) / name, "w", zipfile.ZIP_DEFLATED) as wheel:
        for path, data in files.items():
            wheel.writestr(path, data)
    return name
