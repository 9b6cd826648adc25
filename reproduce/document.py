"""Makes a document of studies from its template: one row per claim, then a section per study."""
import pathlib
import string
import sys
import textwrap

from reproduce import verdicts

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "benchmark/peers"))
import machine  # noqa: E402

WIDTH = 120  # of a line


def table(header, lines):
    """In Markdown."""
    rows = [header, ["---"] * len(header), *lines]
    return "\n".join("| " + " | ".join(str(cell) for cell in row) + " |" for row in rows)


def claims_table(outcomes):
    claims = [claim for outcome in outcomes for claim in outcome.claims()]
    claims.sort(key=lambda claim: (int(claim.number.rstrip(string.ascii_lowercase)), claim.number))
    return table(["#", "where", "claim", "what came out", "verdict"],
                 [[claim.number, claim.where, claim.text, "<br>".join(check.text() for check in claim.checks),
                   f"**{claim.verdict()}**"] for claim in claims])


def span(values, unit):
    return f"{values[0]:g}{unit}" if len(values) == 1 else f"{values[0]:g} to {values[-1]:g}{unit}"


def settings(outcome):
    """What was run: a line for each sweep."""
    lines = []
    for name, rows in outcome.rows.items():
        file = f"[{name}.yaml](../config/sweeps/{name}.yaml)"
        if not rows:
            lines.append(f"- {file}: left out")
            continue
        line = (f"- {file}: {len(rows)} runs of {span(rows.values('simulated_time'), ' s')}, "
                f"seeds {span(rows.values('seed'), '')}")
        lines.append(line + (f"; **{rows.failed} failed** and are left out" if rows.failed else ""))
    return "\n".join(lines)


def samples(outcome):
    """How many independent ones the sweeps have, for a caption."""
    counts = sorted({len(rows.values("seed")) for rows in outcome.rows.values() if rows})
    return f"n = {span(counts, '')}" if counts else "n = 0"


def section(outcome, document):
    parts = [f"## {outcome.study.title}", settings(outcome)]
    for picture in outcome.study.pictures:
        parts.append(f"![{picture.caption}](images/{document}_{picture.name}.png)")
        parts.append(f"*{picture.caption}; {samples(outcome)}*")
    text = outcome.study.text(outcome.numbers).strip()
    return "\n\n".join(parts + ([text] if text else []))


def processor_time(names, costs):
    seconds = [costs.of(name) for name in names]
    if None in seconds:
        return "a processor time that is not known"
    return f"{sum(seconds) / 60.0:.0f} minutes of processor time"


def about(outcomes, command, costs):
    sweeps = {name: rows for outcome in outcomes for name, rows in outcome.rows.items() if rows}
    versions = sorted({row["version"] for rows in sweeps.values() for row in rows})
    physics = sorted({f"{row['physics']:g}" for rows in sweeps.values() for row in rows})
    where = machine.describe()
    return (f"By `{command}`, {where['date']}: {sum(map(len, sweeps.values()))} runs of ratchet_sieve "
            f"{', '.join(versions)}, physics version {', '.join(physics)}, in {processor_time(sweeps, costs)} "
            f"({where['processor']}, {where['cores']} cores, {where['system']}).")


def wrapped(block):
    """A paragraph in lines of WIDTH at most; tables, lists, pictures and titles are left as they are."""
    if block.startswith(("|", "- ", "![", "#")):
        return block
    return textwrap.fill(block, WIDTH, break_long_words=False, break_on_hyphens=False)


def write(path, template, outcomes, command, costs):
    """@param template a file in which $about, $rule, $claims and $study_NAME of each study stand for what came out"""
    known = {"about": about(outcomes, command, costs), "rule": verdicts.RULE, "claims": claims_table(outcomes)}
    known.update({f"study_{outcome.study.name}": section(outcome, path.stem) for outcome in outcomes})
    text = string.Template(template.read_text(encoding="utf-8")).substitute(known)
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text("\n\n".join(map(wrapped, text.strip().split("\n\n"))) + "\n", encoding="utf-8")
