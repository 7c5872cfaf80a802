"""The documentation site: make docs writes it, without network."""

from importlib.metadata import version as installed

project = "segfmu"
author = "the segfmu developers"
release = installed("segfmu")
extensions = [
    "myst_parser", "sphinx.ext.autodoc", "numpydoc",
]
# headings as targets of links, as GitHub makes them
myst_heading_anchors = 4
html_theme = "furo"
html_title = f"segfmu {release}"
html_copy_source = False
html_show_sphinx = False
exclude_patterns = ["README.md"]
numpydoc_show_class_members = False
autodoc_member_order = "bysource"
autodoc_typehints = "none"
autoclass_content = "class"
