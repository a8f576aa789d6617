"""The documentation site. Its sources are the pages in docs/, so Sphinx is told where this is:

    python -m pip install '.[docs,tutorials]'
    python -m sphinx -W --keep-going -c docs/site docs target/site

Notebooks are shown as they are stored. `capwalk` is imported for its docstrings; JAX has to be there, the
other frameworks that it works with need not.
"""

import re
from importlib import metadata

project = "capwalk"
author = copyright = "the capwalk authors"
try:
    release = metadata.version("capwalk")
except metadata.PackageNotFoundError:
    release = ""

extensions = ["myst_nb", "sphinx.ext.autodoc", "sphinx_copybutton"]
exclude_patterns = ["site", "**.ipynb_checkpoints"]

myst_enable_extensions = ["dollarmath"]
myst_heading_anchors = 3
nb_execution_mode = "off"

autodoc_mock_imports = ["drjit", "mitsuba", "ray", "rerun", "torch"]
autodoc_member_order = "bysource"
autodoc_typehints = "none"
autodoc_preserve_defaults = True

# What is copied of an example in a docstring: its code.
copybutton_prompt_text = r">>> |\.\.\. "
copybutton_prompt_is_regexp = True

html_theme = "furo"
html_title = "capwalk"
html_favicon = "favicon.svg"
html_static_path = ["static"]
html_css_files = ["wide.css"]


def without_links_outside(app, page, source):
    """Pages refer to files beside docs/, which are no part of the site: their names are enough."""
    folder = app.env.doc2path(page).parent

    def named(link):
        text, target = link.groups()
        is_inside = (folder / target).resolve().is_relative_to(app.srcdir)
        return link.group() if is_inside else f"`{text}`"

    source[0] = re.sub(r"\[([^\]]+)\]\((\.\./[^)#]+)[^)]*\)", named, source[0])


def setup(app):
    app.connect("source-read", without_links_outside)
