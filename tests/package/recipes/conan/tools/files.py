import fnmatch
import pathlib
import shutil


def copy(recipe, pattern, source, destination):
    """Copies files whose path in the source matches; a star matches slashes, too."""
    source, destination = pathlib.Path(source), pathlib.Path(destination)
    for path in source.rglob("*"):
        name = path.relative_to(source)
        if path.is_file() and fnmatch.fnmatch(str(name), pattern):
            (destination / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(path, destination / name)
