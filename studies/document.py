"""Makes a document of studies from its template: a table of the claims, then a section per study. Studies that the
template does not name stand on a page of their own, whose template is checks.md."""
import re
import string
import textwrap

from ratchet_sieve import origin
from ratchet_sieve.documents import write_figures
from ratchet_sieve.tables import joined, write_csv
from ratchet_sieve.texts import WIDTH, counted, span, table, wrapped
import setups
import verdicts


def order(claim):
    return (claim.is_addition(), int(claim.number.strip(string.ascii_letters)), claim.number)


def claims_of(outcomes):
    return sorted((claim for outcome in outcomes for claim in outcome.claims()), key=order)


def verdict(claim):
    """Its words bold, and the condition."""
    words = "|".join(verdicts.ORDER)
    return re.sub(rf"(^|; )({words})(?=:|$)", r"\1**\2**", claim.verdict()) + f" {claim.condition}".rstrip()


def claims_table(claims):
    return table(["#", "where", "claim", "verdict"],
                 [[claim.number, claim.where, claim.text, verdict(claim)] for claim in claims])


def filled(text, indent):
    """An item of a list, in lines of WIDTH."""
    return textwrap.fill(f"- {text}", WIDTH, initial_indent=indent, subsequent_indent=indent + "  ",
                         break_long_words=False, break_on_hyphens=False)


def checks(claims):
    """What came out of each claim, in an item for each check; of one check in the claim's own. The claims' texts stand in
    their table."""
    lines = []
    for claim in sorted(claims, key=order):
        kind = "Addition" if claim.is_addition() else "Claim"
        begins = f"{kind} {claim.number}{'' if ':' in claim.verdict() else ' ' + verdict(claim)}:"
        if len(claim.checks) == 1:
            lines.append(filled(f"{begins} {claim.checks[0].says}: {claim.checks[0].came_out}", ""))
        else:
            lines += [filled(begins, ""), *(filled(check.text(), "  ") for check in claim.checks)]
    return "\n".join(lines)


def sources(outcome, document, shown):
    """Where a study's pictures, numbers and runs are. @param shown how many pictures the document shows"""
    pictures = [f"[{picture.name}](images/{document}_{picture.name}.png)"
                for picture in outcome.study.pictures[shown:]]
    files = [f"[{name}.csv](data/{document}_{name}.csv)" for name in outcome.study.tables(outcome.numbers)]
    parts = [(f"Picture{'s' if len(pictures) > 1 else ''}", pictures), ("Numbers", files)]
    return " ".join([*(f"{name}: {', '.join(links)}." for name, links in parts if links), runs(outcome)])


def runs(outcome):
    """How many there are of all of a study's sweeps, in words."""
    rows = [rows for rows in outcome.rows.values() if len(rows)]
    if not rows:
        return "Left out."
    every, failed = joined(*rows), sum(part.failed for part in rows)
    return (f"{counted(len(every), 'run')} of {span(every.values('simulated_time'), ' s')}, "
            f"seeds {span(every.values('seed'))}" + (f", **{failed} failed** and left out." if failed else "."))


def section(outcome, document, is_shown=True):
    """@param is_shown whether the document shows the first picture; else it links it"""
    study = outcome.study
    text, found = study.text(outcome.numbers).strip(), sources(outcome, document, int(is_shown))
    parts = [f"## {study.title}", checks(outcome.claims())]
    if not is_shown:
        parts.append(f"{text} {found}".strip())
    else:
        picture = study.pictures[0]
        parts += [text, f"![{picture.caption.split(';')[0]}](images/{document}_{picture.name}.png)",
                  f"*{picture.caption}; {outcome.samples(picture)}.* {found}"]
    return "\n\n".join(part for part in parts if part)


def versions_of(outcomes):
    rows = joined(*(rows for outcome in outcomes for rows in outcome.rows.values()))
    return ", ".join(rows.values("version")), ", ".join(f"{version:g}" for version in rows.values("physics"))


def about(outcomes, command):
    sweeps = {name: rows for outcome in outcomes for name, rows in outcome.rows.items() if rows}
    version, physics = versions_of(outcomes)
    where = origin.describe()
    return (f"By `{command}`, {where['date']}: {counted(sum(map(len, sweeps.values())), 'run')} of "
            f"ratchet_sieve {version}, physics version {physics} ({where['machine']}).")


def write(path, template, outcomes, command):
    """@param template a file in which some of $about, $rule, $claims, $additions, $machines and $study_NAME stand for
    what came out, and in checks.md beside it $checks for all other studies, which go to NAME_checks.md"""
    claims = claims_of(outcomes)
    known = {"about": about(outcomes, command), "rule": verdicts.RULE,
             "claims": claims_table([claim for claim in claims if not claim.is_addition()]),
             "additions": claims_table([claim for claim in claims if claim.is_addition()]),
             "machines": setups.machines([outcome.study for outcome in outcomes])}
    text, others = template.read_text(encoding="utf-8"), []
    for outcome in outcomes:
        name = f"study_{outcome.study.name}"
        if f"${name}\n" in text:
            known[name] = section(outcome, path.stem)
        else:
            others.append(section(outcome, path.stem, False))
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(wrapped(string.Template(text).substitute(known)), encoding="utf-8")
    if others:
        text = template.with_name("checks.md").read_text(encoding="utf-8")
        path.with_stem(f"{path.stem}_checks").write_text(
            wrapped(string.Template(text).substitute(known, checks="\n\n".join(others))), encoding="utf-8")
    write_data(path, outcomes, claims)


def write_data(path, outcomes, claims):
    """Beside the document, in data/: the studies' tables, and NAME.json with what other documents quote."""
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
