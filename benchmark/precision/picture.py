"""Error over processor time, a panel for each scene: of the method (steps), and of what the model leaves out."""
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.ticker import NullFormatter  # noqa: E402

from peers.picture import LOOKS, STYLE  # noqa: E402
from precision import errors, rungs  # noqa: E402

METHOD_PANELS = (("ball", "kinetic energy"), ("gas", "K_rot / K_trans"), ("fig8", "N m g T"), ("fig8", "drift A"),
                 ("fig8", "drift B"), ("fig9", "Q"), ("dense", "drift B"), ("violent", "K_B"))
MODEL_PANELS = (("fig3", "drift A"), ("fig8", "drift A"), ("fig8", "drift B"), ("fig9", "Q"), ("dense", "drift B"),
                ("violent", "K_B"))
LIMITS = (3e-4, 3.0)  # of the relative error; what is beyond is drawn at the edge
ROOM = 3.2            # beside the cheapest and the dearest point: their times this

# Okabe and Ito's colours.
FAMILIES = {"exact": ("#111111", "D"), "steps": ("#CC79A7", "o"), "rebound floor": ("#0072B2", "s"),
            "contact duration": ("#D55E00", "^"), "restitution by speed": ("#009E73", "v"),
            "floor, in steps of 1 ms": ("#CC79A7", "o"), "no spin": ("#E69F00", "P"), "no pairs": ("#56B4E9", "X")}


def clip(value):
    return min(max(value, LIMITS[0]), LIMITS[1])


def draw_point(axes, cost, found, look, fails):
    """Filled where it is off by more than two standard errors, open where that is not sure, a cross where it fails."""
    colour, marker = look
    error, spread = found
    size = clip(abs(error))
    axes.plot([cost, cost], [clip(abs(error) - spread), clip(abs(error) + spread)], color=colour, linewidth=1.0)
    if fails:
        axes.plot(cost, size, "x", color=colour, markersize=8, markeredgewidth=2, zorder=4)
        return
    axes.plot(cost, size, marker, color=colour, markersize=5, zorder=3,
              markerfacecolor=colour if abs(error) > 2.0 * spread else "white")


def draw_family(axes, family, points, name, reference):
    drawn = []
    for point in points:
        found = errors.relative(point, name, reference)
        if found is None or point.cost() is None:
            continue
        draw_point(axes, point.cost(), found, FAMILIES[family], point.fails())
        drawn.append((point, point.cost(), clip(abs(found[0]))))
    axes.plot([d[1] for d in drawn], [d[2] for d in drawn], color=FAMILIES[family][0], linewidth=0.8, zorder=2)
    named = drawn if family == "steps" else drawn[:1] + drawn[1:][-1:]
    for point, cost, size in named:
        axes.annotate(point.label, (cost, size), textcoords="offset points", xytext=(4, 5), fontsize=6,
                      color=FAMILIES[family][0])


def draw_peers(axes, peers, name):
    """Against this project without tangential restitution, as they are."""
    species = {"drift A": 0, "drift B": 1}[name]
    value, error = peers.reference[species]
    for program in LOOKS:
        rows = [row for row in peers.rows if row.program == program]
        for row in rows:
            drift, spread = row.drifts[species]
            found = (drift - value) / value, (spread ** 2 + error ** 2) ** 0.5 / value
            draw_point(axes, row.cost, found, LOOKS[program][1:3], row.lost)
        axes.plot([r.cost for r in rows], [clip(abs(r.drifts[species][0] / value - 1.0)) for r in rows],
                  color=LOOKS[program][1], linewidth=0.8)


def finish(axes, title, exact_cost):
    costs = [cost for line in axes.lines for cost in line.get_xdata()] + [exact_cost or 1.0]
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlim(min(costs) / ROOM, max(costs) * ROOM)
    axes.set_ylim(LIMITS[0] / 1.3, LIMITS[1] * 1.3)
    axes.xaxis.set_minor_formatter(NullFormatter())
    axes.set_title(title, loc="left", fontsize=8)
    if exact_cost:
        axes.axvline(exact_cost, color=FAMILIES["exact"][0], linewidth=0.8, linestyle=":")


def legend(figure, axes, names):
    for name in names:
        colour, marker = FAMILIES[name] if name in FAMILIES else LOOKS[name][1:3]
        axes.plot([], [], marker + "-", color=colour, markersize=5, label=LOOKS[name][0] if name in LOOKS else name)
    axes.plot([], [], "o", color="#555555", markerfacecolor="white", markersize=5, label="not told from 0 (2 σ)")
    axes.plot([], [], "x", color="#555555", markersize=7, markeredgewidth=2, label="lost disks, or ended early")
    axes.plot([], [], ":", color="#111111", label="cost of the exact engine")
    handles, labels = axes.get_legend_handles_labels()
    figure.legend(handles, labels, ncol=min(len(labels), 5), loc="lower center")


def save(figure, panels, path):
    for axes in panels[-1]:
        axes.set_xlabel("processor s per simulated s")
    for row in panels:
        row[0].set_ylabel("relative error")
    figure.tight_layout(rect=(0.0, 0.08, 1.0, 1.0))
    path.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(path)
    plt.close(figure)


def cost_of_exact(points):
    return next((p.cost() for p in points if p.family == "exact"), None)


def draw_method(by_scene, peers, path):
    with plt.rc_context(STYLE):
        figure, panels = plt.subplots(2, 4, figsize=(12.0, 6.0))
        for (scene, name), axes in zip(METHOD_PANELS, panels.flat):
            points = by_scene.get(scene)
            if not points:
                continue
            reference = errors.exact(points, name)
            draw_family(axes, "steps", [p for p in points if p.family == "steps"], name, reference)
            if name in points[0].scene.known:
                draw_family(axes, "exact", [p for p in points if p.family == "exact"], name, reference)
            if scene == "fig8" and name.startswith("drift") and peers:
                draw_peers(axes, peers, name)
            finish(axes, f"{points[0].scene.title}: {name}", cost_of_exact(points))
        legend(figure, panels[0][0], ["steps", "exact", *(LOOKS if peers else ())])
        save(figure, panels, path)


def draw_model(by_scene, path):
    families = ["rebound floor", *(name for name in rungs.MODEL if name != "rebound floor")]
    with plt.rc_context(STYLE):
        figure, panels = plt.subplots(2, 3, figsize=(11.0, 6.5))
        for (scene, name), axes in zip(MODEL_PANELS, panels.flat):
            points = by_scene.get(scene)
            if not points:
                continue
            reference = errors.limit(points, name)
            for family in families:
                own = [p for p in points if p.family == family or (family == "rebound floor" and p.family == "exact")]
                if family == "rebound floor":
                    own.sort(key=rungs.floor_of, reverse=True)
                draw_family(axes, family, own, name, reference)
            finish(axes, f"{points[0].scene.title}: {name}", cost_of_exact(points))
        legend(figure, panels[0][0], families)
        save(figure, panels, path)
