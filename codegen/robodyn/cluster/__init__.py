"""Where independent pieces of work run: in this process, in others of this machine, on a Dask scheduler."""

from robodyn.cluster.cluster import Cluster, Done, Failed, Security
from robodyn.cluster.opening import check_place, open_cluster

__all__ = ["Cluster", "Done", "Failed", "Security", "check_place", "open_cluster"]
