"""The .meta file of everything in a Unity package. A GUID is made of its asset's path, so that it stays what it is in the
scenes of users for as long as the file keeps its place."""

import hashlib
from pathlib import PurePosixPath

PACKAGE = "com.palpate.haptics"
EMPTY = "  externalObjects: {}\n  userData: \n  assetBundleName: \n  assetBundleVariant: \n"
SCRIPT = ("MonoImporter:\n  externalObjects: {}\n  serializedVersion: 2\n  defaultReferences: []\n  executionOrder: 0\n"
          "  icon: {instanceID: 0}\n  userData: \n  assetBundleName: \n  assetBundleVariant: \n")
LIBRARY = """PluginImporter:
  externalObjects: {}
  serializedVersion: 2
  iconMap: {}
  executionOrder: {}
  defineConstraints: []
  isPreloaded: 0
  isOverridable: 0
  isExplicitlyReferenced: 0
  validateReferences: 1
  platformData:
  - first:
      : Any
    second:
      enabled: 0
      settings:
        Exclude Editor: 0
        Exclude Linux64: 0
  - first:
      Any:
    second:
      enabled: 0
      settings: {}
  - first:
      Editor: Editor
    second:
      enabled: 1
      settings:
        CPU: x86_64
        DefaultValueInitialized: true
        OS: Linux
  - first:
      Standalone: Linux64
    second:
      enabled: 1
      settings:
        CPU: x86_64
  userData:
  assetBundleName:
  assetBundleVariant:
"""
IMPORTERS = {
    ".cs": SCRIPT,
    ".so": LIBRARY,
    ".asmdef": "AssemblyDefinitionImporter:\n" + EMPTY,
    ".md": "TextScriptImporter:\n" + EMPTY,
    ".json": "PackageManifestImporter:\n" + EMPTY,
}
FOLDER = "folderAsset: yes\nDefaultImporter:\n" + EMPTY


def guid(path):
    return hashlib.md5(f"{PACKAGE}/{path}".encode()).hexdigest()


def is_hidden(path):
    """Unity imports no folder whose name ends in ~."""
    return any(part.endswith("~") for part in PurePosixPath(path).parts)


def text(path, is_folder):
    importer = FOLDER if is_folder else IMPORTERS[PurePosixPath(path).suffix]
    return f"fileFormatVersion: 2\nguid: {guid(path)}\n{importer}"
