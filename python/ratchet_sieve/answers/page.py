"""An answer as a page for any browser: src/page/web/answer."""
from __future__ import annotations

import base64
import io
import json
import os
from typing import Any

from ratchet_sieve import _engine
from ratchet_sieve.texts import plus_minus

BATCH = 100.0  # that is shown [kg per metre of depth]


def page_of(answer: Any) -> str:
    """HTML."""
    result, *lines = str(answer).splitlines()
    scene = answer.machine.scene
    return _engine.answer_page(json.dumps({
        "title": f"Which settings part {' and '.join(scene.species)}", "result": result,
        "origin": f"{os.path.basename(scene.source)}, seed {scene['seed']}, ratchet_sieve {_engine.__version__}",
        "lines": lines, "picture": answer.best and _picture(answer), "scene": answer.best and answer.scene.yaml,
        "tables": [table(answer) for table in (_as_good, _depends, _stages, _batch) if answer.best and table(answer)]}))


def _picture(answer: Any) -> dict:
    from ratchet_sieve.plots.style import styled

    picture = io.BytesIO()
    with styled():
        answer.plot().figure.savefig(picture, format="png", dpi=150, bbox_inches="tight")
    return {"bytes": base64.b64encode(picture.getvalue()).decode(),
            "says": f"{answer.machine.goal} over {', '.join(answer.machine.keys)}: best, as good, runs"}


def _as_good(answer: Any) -> dict:
    from ratchet_sieve.plots.means import plain_label

    goal, keys = answer.machine.goal, answer.machine.keys
    unit = " [m/s]" if answer.machine.kind == "closed" and answer.machine.is_signed else ""
    heads = [f"{name} [{of}]" if of else name for name, of in map(plain_label, keys)]
    rows = [[*(f"{row[key]:.4g}" for key in keys), plus_minus(row["value"], row["half_width"]),
             f"{row['may_lose']:.2g}", *(_text(row.get(name)) for name in ("processed", "throughput", "inside")),
             str(row.get("warnings") or "")] for row in answer.as_good.to_dict("records")]
    return {"title": "Settings that are as good", "rows": rows,
            "note": "By the surface through all runs, at 95 %; P, throughput and disks inside: of the nearest run.",
            "head": [*heads, goal + unit, "may lose" + unit, "P", "throughput [1/s]", "disks inside", "warnings"]}


def _depends(answer: Any) -> Any:
    if answer.depends_on is None or not len(answer.depends_on):
        return None
    low, high = answer.spread
    return {"title": "What is not known of the grains", "head": ["key", "share of the variance", "standard error"],
            "note": f"{answer.machine.goal} from {low:.3g} to {high:.3g} for 95 % of what the unknown keys leave open.",
            "rows": [[row["key"], f"{row['share']:.2f}", f"{row['error']:.2f}"]
                     for row in answer.depends_on.to_dict("records")]}


def _stages(answer: Any) -> Any:
    if not answer.stages:
        return None
    names = answer.machine.scene.species
    return {"title": "Products of all stages", "note": "By mass, at 95 %; throughput in one plane of disks.",
            "head": ["product", *(f"{what} {name}" for name in names for what in ("purity", "recovery")),
                     "throughput [g/s]"],
            "rows": [[f"stage {one.stage}, {one.side}", *(str(share.mass[name]) for name in names
                                                          for share in (one.purity, one.recovery)),
                      f"{1e3 * one.throughput.value:.3g}"] for one in answer.stages.products]}


def _batch(answer: Any) -> Any:
    try:
        batch = answer.batch(BATCH)
    except ValueError:
        return None
    return {"title": f"A batch of {BATCH:g} kg per metre of depth", "note": f"It takes {batch.hours} h.",
            "head": ["product", *(f"{name} [kg]" for name in answer.machine.scene.species)],
            "rows": [[side, *map(str, masses.values())] for side, masses in batch.products.items()]}


def _text(value: Any) -> str:
    return "\u2014" if value is None or value != value else f"{value:.3g}" if isinstance(value, float) else str(value)
