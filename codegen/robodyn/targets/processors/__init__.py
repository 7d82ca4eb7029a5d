"""The targets, one module each: to add one, add a module (CONTRIBUTING.md, "Add a target")."""
