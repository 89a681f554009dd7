#!/usr/bin/env python3
"""pack.py LIBRARY PACKAGE.tgz: makes the Unity package, with the native library and all that it needs inside. The same
inputs give the same bytes."""

import gzip
import io
import json
import sys
import tarfile
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path.insert(0, str(HERE.parent / "bundle"))

import bundle  # noqa: E402  (its folder was not in the path before)
import meta  # noqa: E402

PLUGINS = "Runtime/Plugins/x86_64"
TAKEN = (".cs", ".asmdef", ".md", ".json")


def own_files():
    """What the package holds beside the library: its bytes by its path."""
    files = {str(path.relative_to(HERE)): path.read_bytes() for path in HERE.rglob("*") if path.suffix in TAKEN}
    for source in (ROOT / "bindings" / "csharp" / "src").glob("*.cs"):
        files[f"Runtime/Binding/{source.name}"] = source.read_bytes()
    files[f"Documentation~/{meta.PACKAGE}.md"] = files["README.md"]
    files["LICENSE.md"] = (ROOT / "LICENSE").read_bytes()
    files["CHANGELOG.md"] = (ROOT / "CHANGELOG.md").read_bytes()
    return files


def native_files(library):
    with tempfile.TemporaryDirectory() as folder:
        originals = bundle.bundle(library, folder)
        files = {f"{PLUGINS}/{path.name}": path.read_bytes() for path in Path(folder).iterdir()}
    files["Third Party Notices.md"] = bundle.notices(originals).encode()
    return files


def with_metas(files):
    folders = {str(parent) for path in files for parent in Path(path).parents} - {"."}
    metas = {f"{path}.meta": meta.text(path, path in folders).encode()
             for path in [*files, *folders] if not meta.is_hidden(path)}
    return {**files, **metas}


def archive(files):
    """As npm and Unity want it: everything below package/. No time, owner or order of this machine gets in."""
    tar_bytes = io.BytesIO()
    with tarfile.open(fileobj=tar_bytes, mode="w", format=tarfile.USTAR_FORMAT) as tar:
        for path, data in sorted(files.items()):
            entry = tarfile.TarInfo(f"package/{path}")
            entry.size, entry.mode = len(data), 0o644
            tar.addfile(entry, io.BytesIO(data))
    packed = io.BytesIO()
    with gzip.GzipFile(fileobj=packed, mode="wb", mtime=0) as stream:
        stream.write(tar_bytes.getvalue())
    return packed.getvalue()


def main():
    if len(sys.argv) != 3:
        print(__doc__, file=sys.stderr)
        return 2
    try:
        files = with_metas({**own_files(), **native_files(sys.argv[1])})
    except (bundle.BundleError, OSError) as error:
        print(error, file=sys.stderr)
        return 1
    target = Path(sys.argv[2])
    target.parent.mkdir(parents=True, exist_ok=True)
    target.write_bytes(archive(files))
    version = json.loads(files["package.json"])["version"]
    print(f"{target}: version {version}, {len(files)} files, {target.stat().st_size} bytes")
    return 0


if __name__ == "__main__":
    sys.exit(main())
