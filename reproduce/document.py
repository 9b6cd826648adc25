"""Makes a document of studies from its template: one row per claim, then a section per study."""
import datetime
import pathlib
import string

import machine
from reproduce import verdicts

ROOT = pathlib.Path(__file__).resolve().parent.parent


def table(header, lines):
    """Markdown."""
    rows = [header, ["---"] * len(header), *lines]
    return "\n".join("| " + " | ".join(str(cell) for cell in row) + " |" for row in rows)


def claims_table(outcomes):
    claims = [claim for outcome in outcomes for claim in outcome.claims()]
    claims.sort(key=lambda claim: (len(claim.number), claim.number))
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
                f"seeds {span(rows.values('seed'), '')}, {seconds(rows):.0f} s of one core")
        lines.append(line + (f"; **{rows.failed} failed** and are left out" if rows.failed else ""))
    return "\n".join(lines)


def section(outcome, document):
    parts = [f"## {outcome.study.title}", settings(outcome)]
    for picture in outcome.study.pictures:
        parts.append(f"![{picture.caption}](images/{document}_{picture.name}.png)")
        parts.append(f"*{picture.caption}*")
    text = outcome.study.text(outcome.numbers).strip()
    return "\n\n".join(parts + ([text] if text else []))


def seconds(rows):
    """Of one thread, start and all but the program's own."""
    return sum(rows.samples("wall_time"))


def about(outcomes, command):
    sweeps = {name: rows for outcome in outcomes for name, rows in outcome.rows.items() if rows}
    versions = sorted({row["version"] for rows in sweeps.values() for row in rows})
    physics = sorted({f"{row['physics']:g}" for rows in sweeps.values() for row in rows})
    where = machine.describe()
    return (f"`{command}`, {datetime.date.today()}: {sum(map(len, sweeps.values()))} runs by ratchet_sieve "
            f"{', '.join(versions)}, physics version {', '.join(physics)}; "
            f"{sum(map(seconds, sweeps.values())) / 60.0:.0f} minutes of one core in all, as the sum of the runs' wall times, "
            f"one thread each ({where['processor']}, {where['cores']} cores, {where['system']}).")


def write(path, template, outcomes, command):
    """@param template a file in which $about, $rule, $claims and $study_NAME of each study stand for what came out"""
    known = {"about": about(outcomes, command), "rule": verdicts.RULE, "claims": claims_table(outcomes)}
    known.update({f"study_{outcome.study.name}": section(outcome, path.stem) for outcome in outcomes})
    text = string.Template(template.read_text(encoding="utf-8")).substitute(known)
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text.rstrip() + "\n", encoding="utf-8")
