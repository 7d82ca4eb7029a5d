"""A scheduler and two workers of their own, that know each other and robodyn by certificates."""

from __future__ import annotations

import socket
from collections.abc import Iterator
from pathlib import Path

import pytest
import yaml

from cluster.functions import square
from robodyn.cluster import Done, Security, open_cluster, opening
from robodyn.errors import InputError, ToolError
from robodyn_testing import require_module
from robodyn_testing.dask_machines import Machines, certificates

require_module("distributed")
DOCUMENT = Path(__file__).parents[2] / "docs" / "fleet-cluster.md"


@pytest.fixture(scope="module")
def security(tmp_path_factory: pytest.TempPathFactory) -> Security:
    return Security(*map(str, certificates(tmp_path_factory.mktemp("certificates"))))


@pytest.fixture(scope="module")
def machines(tmp_path_factory: pytest.TempPathFactory, security: Security) -> Iterator[Machines]:
    """Started with the configuration of the document."""
    folder = tmp_path_factory.mktemp("machines")
    text = DOCUMENT.read_text(encoding="utf-8").partition("<!-- configuration -->")[2]
    text = text.partition("```yaml\n")[2].partition("```")[0]
    (folder / "tls.yaml").write_text(text.replace("/etc/fleet", str(Path(security.key).parent)))
    assert set(yaml.safe_load(text)["distributed"]["comm"]["tls"]) == {
        "ca-file",
        "scheduler",
        "worker",
        "client",
    }
    with Machines(folder, {"DASK_CONFIG": str(folder)}, scheme="tls") as started:
        started.scheduler()
        started.worker()
        started.worker()
        yield started


@pytest.mark.thorough
def test_work_on_a_scheduler_with_tls(machines: Machines, security: Security) -> None:
    with open_cluster(f"dask://{machines.address}", security=security) as cluster:
        results = dict(cluster.each(square, ((k, (k,)) for k in range(100))))
        assert cluster.count == 2
    assert results == {k: Done(k * k) for k in range(100)}


@pytest.mark.thorough
def test_without_a_certificate_nobody_is_let_in(
    machines: Machines, security: Security, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(opening, "CONNECT", 3.0)
    address = f"dask://{machines.address}"
    refused = pytest.raises(ToolError, match=r"does not answer.*whether both sides use TLS")
    with refused, open_cluster(address):
        pass
    strangers = Security(*map(str, certificates(tmp_path)))  # signed by an authority that nobody knows
    with refused, open_cluster(address, security=strangers):
        pass


def test_files_that_are_no_certificates(security: Security, tmp_path: Path) -> None:
    other = tmp_path / "words.pem"
    other.write_text("no certificate")
    for bad in (
        Security(security.authority, str(tmp_path / "none.pem"), security.key),
        Security(str(other), security.certificate, security.key),
        Security(security.authority, security.certificate, security.authority),
    ):
        message = "a certificate or its key cannot be used"
        with pytest.raises(InputError, match=message) as error, open_cluster("dask://host:1", security=bad):
            pass
        assert bad.certificate in str(error.value)


@pytest.mark.thorough
def test_where_nobody_answers(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(opening, "CONNECT", 1.0)
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        address = f"127.0.0.1:{free.getsockname()[1]}"
        message = f"the scheduler dask://{address} does not answer; expected an answer within 1 s"
        with pytest.raises(ToolError, match=message), open_cluster(f"dask://{address}"):
            pass
