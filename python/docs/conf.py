"""The pages of `docs.sh`: what docstrings say, and the figures of the tutorial."""

import importlib
import sys
from pathlib import Path

import dq8

project, copyright, version = "dq8", "the dq8 contributors", dq8.__version__
extensions = ["sphinx.ext.autodoc", "sphinx.ext.napoleon", "sphinx.ext.mathjax", "myst_parser"]
html_theme, html_title = "alabaster", "dq8: rigid motions for NumPy arrays"
html_theme_options = {"description": "Rigid motions as dual quaternions", "page_width": "1100px"}
# Formulas stand between double backquotes, single ones are names.
default_role = "code"
autodoc_typehints = "none"
napoleon_use_rtype = False
napoleon_use_param = False
exclude_patterns = ["_build"]
# README.md links files of the repository.
suppress_warnings = ["myst.xref_missing", "myst.header"]

HERE = Path(__file__).parent
CAPTIONS = {
    "between": "Between two motions: screws, straight lines and what else interpolates",
    "keys": "Through many: keys in a row",
    "deskew": "A cloud whose points were measured on the way, before and after `deskew`",
    "arm": "An arm reaches its target",
    "robot": "A robot from a URDF file",
    "skin": "A mesh follows its joints",
}


def api() -> str:
    """A page of all public names: classes first, then functions, then the modules."""
    classes = [name for name in dq8.__all__ if isinstance(getattr(dq8, name), type)]
    functions = [name for name in dq8.__all__ if name not in classes]
    lines = ["All names", "=========", "", ".. automodule:: dq8", "   :no-index:", ""]
    lines += ["Nouns", "-----", ""]
    for name in classes:
        lines += [f".. autoclass:: dq8.{name}", "   :members:", "   :undoc-members:", ""]
    lines += ["Functions", "---------", ""]
    lines += [f".. autofunction:: dq8.{name}" for name in functions]
    for module in ("dask", "plot", "retarget"):
        importlib.import_module(f"dq8.{module}")
        lines += ["", f"dq8.{module}", "-" * (4 + len(module)), "", f".. automodule:: dq8.{module}", "   :members:", ""]
    return "\n".join(lines) + "\n"


def gallery() -> str:
    """The figures that the tutorial has drawn into `figures/`, each with its caption."""
    lines = ["Gallery", "=======", "", "What ``python/tutorial/tutorial.py`` draws, and the text that it prints beside.", ""]
    for name, caption in CAPTIONS.items():
        lines += [f".. figure:: figures/{name}.png", "   :width: 80%", "", f"   {caption}", ""]
    lines += ["The tutorial", "------------", "", ".. literalinclude:: tutorial.py", "   :language: python", ""]
    return "\n".join(lines)


def setup(app):
    source = Path(app.srcdir)
    missing = [name for name in CAPTIONS if not (source / "figures" / f"{name}.png").is_file()]
    if missing:
        sys.exit(f"no figures {missing}: docs.sh draws them first")
    (source / "api.rst").write_text(api())
    (source / "gallery.rst").write_text(gallery())
