"""The files of a diagnosis: data, the amended description, a page, kernels."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, Final

if TYPE_CHECKING:
    from robodyn.diagnose.result import Diagnosis

DATA: Final = "diagnosis.json"
MODEL: Final = "model.yaml"
REPORT: Final = "report.html"
KERNELS: Final = "kernels"


def files_of(diagnosis: Diagnosis, *, validated: bool = False) -> dict[str, str]:
    """Data, the amended description and the page of ``diagnosis``, by their names; ``validated``: the last of
    its logs was not fitted."""
    from robodyn.report.diagnosis import page

    data = json.dumps(_finite(diagnosis.to_dict()), indent=2, ensure_ascii=False, allow_nan=False)
    return {
        DATA: f"{data}\n",
        MODEL: diagnosis.model_text,
        REPORT: page(diagnosis, validated=validated),
    }


def kernels_of(diagnosis: Diagnosis) -> dict[str, str]:
    """C and Fortran of the amended model, by their paths in the folder."""
    from robodyn.kernels.generate import generate

    return {f"{KERNELS}/{name}": text for name, text in generate(diagnosis.model).files().items()}


def _finite(value: Any) -> Any:
    """``value`` for JSON: non-finite numbers, such as the error of an unidentifiable parameter, are null."""
    if isinstance(value, Mapping):
        return {key: _finite(each) for key, each in value.items()}
    if isinstance(value, (list, tuple)):
        return [_finite(each) for each in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value
