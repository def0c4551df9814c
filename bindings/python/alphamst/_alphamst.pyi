from typing import Any

class Handle:
    """A handle of the library."""

    @property
    def closed(self) -> bool:
        """Whether it is closed."""

    @property
    def parent(self) -> Any:
        """Whose callbacks and data it uses: the context of a mesh, the mesh of patches."""

    def close(self) -> None:
        """End it now and not when it is collected."""

# The functions of alphamst.h, with their arguments but for lengths, capacities and outputs, which are returned.
def __getattr__(name: str) -> Any: ...
