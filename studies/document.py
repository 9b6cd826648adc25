"""Makes a document of studies from its template: a table of the claims, then a section per study."""
import string

from ratchet_sieve import origin
from ratchet_sieve.documents import write_figures
from ratchet_sieve.tables import joined, write_csv
from ratchet_sieve.texts import counted, span, table, wrapped
import verdicts

SAID = {verdicts.HOLDS: ("holds", "hold"), verdicts.IN_PART: ("holds in part", "hold in part"),
        verdicts.POSSIBLE: ("is possible", "are possible"), verdicts.FAILS: ("does not hold", "do not hold"),
        verdicts.UNDECIDED: ("is undecided", "are undecided")}  # of one claim, of several


def order(claim):
    return (claim.is_addition(), int(claim.number.strip(string.ascii_letters)), claim.number)


def claims_of(outcomes):
    return sorted((claim for outcome in outcomes for claim in outcome.claims()), key=order)


def claims_table(claims):
    return table(["#", "where", "claim", "verdict"],
                 [[claim.number, claim.where, claim.text, f"**{claim.verdict()}** {claim.condition}".strip()]
                  for claim in claims])


def listed(claims, verdict):
    return [claim.number for claim in claims if claim.verdict() == verdict]


def summary(claims):
    """How many claims came out, in one paragraph."""
    own = [claim for claim in claims if not claim.is_addition()]
    told = []
    for verdict, (one, several) in SAID.items():
        numbers = listed(own, verdict)
        if numbers:
            told.append(f"{len(numbers)} {one if len(numbers) == 1 else several} ({', '.join(numbers)})")
    return f"Of {counted(len(own), 'claim')} {', '.join(told)}."


def settings(outcome):
    """What was run: a line for each sweep."""
    lines = []
    for name, rows in outcome.rows.items():
        file = f"[{name}.yaml](../config/sweeps/{name}.yaml)"
        if not len(rows):
            lines.append(f"- {file}: left out")
            continue
        line = (f"- {file}: {counted(len(rows), 'run')} of {span(rows.values('simulated_time'), ' s')}, "
                f"seeds {span(rows.values('seed'))}")
        lines.append(line + (f"; **{rows.failed} failed** and left out" if rows.failed else ""))
    return "\n".join(lines)


def checks(claim):
    """What came out of a claim, a line for each check."""
    kind = "Addition" if claim.is_addition() else "Claim"
    head = f"{kind} {claim.number}, {claim.text}: **{claim.verdict()}**"
    return "\n\n".join((head + (f" {claim.condition}" if claim.condition else "") + ".",
                        "\n".join(f"- {check.text()}" for check in claim.checks)))


def section(outcome, document):
    parts = [f"## {outcome.study.title}", *map(checks, sorted(outcome.claims(), key=order))]
    for picture in outcome.study.pictures:
        note = outcome.samples(picture)
        parts.append(f"![{picture.caption}](images/{document}_{picture.name}.png)")
        parts.append(f"*{picture.caption}; {note}*")
    text = outcome.study.text(outcome.numbers).strip()
    files = [f"[{document}_{name}.csv](data/{document}_{name}.csv)" for name in outcome.study.tables(outcome.numbers)]
    parts += [text] if text else []
    parts += [f"All numbers: {', '.join(files)}."] if files else []
    return "\n\n".join([*parts, "Sweeps:", settings(outcome)])


def versions_of(outcomes):
    rows = joined(*(rows for outcome in outcomes for rows in outcome.rows.values()))
    return ", ".join(rows.values("version")), ", ".join(f"{version:g}" for version in rows.values("physics"))


def about(outcomes, command):
    """Of a run, which has one thread, the wall time is its processor time."""
    sweeps = {name: rows for outcome in outcomes for name, rows in outcome.rows.items() if rows}
    version, physics = versions_of(outcomes)
    where = origin.describe()
    minutes = sum(rows.column("wall_time").sum() for rows in sweeps.values()) / 60.0
    return (f"By `{command}`, {where['date']}: {counted(sum(map(len, sweeps.values())), 'run')} of "
            f"ratchet_sieve {version}, physics version {physics}, in {minutes:.0f} minutes of processor time "
            f"({where['machine']}).")


def write(path, template, outcomes, command):
    """@param template a file in which $about, $rule, $summary, $claims, $additions and $study_NAME of each study stand
    for what came out"""
    claims = claims_of(outcomes)
    known = {"about": about(outcomes, command), "rule": verdicts.RULE, "summary": summary(claims),
             "claims": claims_table([claim for claim in claims if not claim.is_addition()]),
             "additions": claims_table([claim for claim in claims if claim.is_addition()])}
    known.update({f"study_{outcome.study.name}": section(outcome, path.stem) for outcome in outcomes})
    text = string.Template(template.read_text(encoding="utf-8")).substitute(known)
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(wrapped(text), encoding="utf-8")
    write_data(path, outcomes, claims)


def write_data(path, outcomes, claims):
    """Beside the document, in data/: the studies' tables, and NAME.json with what other documents quote, if anything."""
    directory = path.parent / "data"
    directory.mkdir(exist_ok=True)
    figures = {}
    for outcome in outcomes:
        figures.update(outcome.study.figures(outcome.numbers))
        for name, (header, lines) in outcome.study.tables(outcome.numbers).items():
            write_csv(directory / f"{path.stem}_{name}.csv", header, lines)
    if figures:
        version, physics = versions_of(outcomes)
        figures.update({f"claim.{claim.number.lower()}.verdict": claim.verdict() for claim in claims})
        write_figures(directory / f"{path.stem}.json", {
            **figures, **origin.describe(), "version": f"{version}, physics version {physics}"})
