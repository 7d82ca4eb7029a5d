"""What Zephyr's scripts do with a module and a prj.conf: read both, and print the configuration for CMake."""

import os
import sys
from pathlib import Path

import kconfiglib
import yaml

module, project = map(Path, sys.argv[1:])
described = yaml.safe_load((module / "zephyr" / "module.yml").read_text())
build = described["build"]
os.environ["MODULE_KCONFIG"] = str(module / build["kconfig"])
kconfig = kconfiglib.Kconfig(str(Path(__file__).parent / "Kconfig"), warn_to_stderr=False)
kconfig.load_config(str(project))
if kconfig.warnings:  # a name or a value that Zephyr would refuse
    sys.exit("\n".join(kconfig.warnings))
for line in project.read_text().splitlines():
    name, _, value = line.removeprefix("CONFIG_").partition("=")
    if value and kconfig.syms[name].str_value != value:
        sys.exit(f"{name} was set to {value} and is {kconfig.syms[name].str_value}")
for symbol in kconfig.unique_defined_syms:
    if symbol.str_value != "n":
        print(f'set(CONFIG_{symbol.name} "{symbol.str_value}")')
print(f'set(module_name "{described["name"]}")')
print(f'set(module_cmake "{module / build["cmake"]}")')
