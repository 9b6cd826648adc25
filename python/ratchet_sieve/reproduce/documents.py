"""The documents, and the studies of each in their order."""
import dataclasses
import pathlib

from ratchet_sieve.reproduce import paper, validation

HERE = pathlib.Path(__file__).resolve().parent


@dataclasses.dataclass(frozen=True)
class Document:
    name: str        # of its file in docs/, and at the start of its pictures' names
    template: pathlib.Path
    studies: tuple


DOCUMENTS = (Document("paper", HERE / "paper/template.md", paper.STUDIES),
             Document("validation", HERE / "validation/template.md", validation.STUDIES))
