"""The pages of the documentation site that nobody writes by hand: made from the code when the site is built.

Each module makes the pages of one folder as ``{path: Markdown}``; :mod:`robodyn_site.pages` puts them
together. Nothing here needs mkdocs, which only ``docs/hook.py`` does.
"""
