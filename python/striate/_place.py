"""Where the shipped tasks, worlds and robots are: beside this package, as they are beside the program."""

import pathlib

from ._striate import _set_program_folder


def _program_folder():
    for folder in pathlib.Path(__file__).absolute().parents:
        if (folder / "share" / "striate" / "config" / "tasks").is_dir():
            return folder / "bin"  # an installation
        if (folder / "config" / "tasks").is_dir() and (folder / "python" / "striate").is_dir():
            return folder  # a build, or the sources
    return None


def tell():
    """Tells the library, which would look beside the interpreter else."""
    folder = _program_folder()
    if folder is not None:
        _set_program_folder(folder)
