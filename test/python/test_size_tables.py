"""size_table(): sieve analyses as laboratories send them, and those that are not clear."""
import numpy as np
import pytest

import ratchet_sieve as rs

GERMAN = """Siebanalyse nach DIN 66165-2;;;;
Probe: PET-Flakes, Charge 24/117;;;;
Einwaage [g];250,4;;;
Siebdauer;10 min;;;

Maschenweite [mm];Sieb leer [g];Sieb + Probe [g];Rückstand [g];Durchgang [%]
4,000;412,3;412,3;0,0;100,0
3,150;398,1;429,1;31,0;87,6
2,800;390,0;457,8;67,8;60,4
2,360;377,2;456,7;79,5;28,6
2,000;360,6;411,1;50,5;8,4
Boden;300,0;321,0;21,0;-
Summe;;;249,8;
Siebverlust [%];0,2;;;
"""
ENGLISH = """Sieve analysis to ASTM C136/C136M
"Sample","Quartz sand, lot 7"
"Dry mass (g)","1,204.6"

Sieve No.,Sieve size (mm),Mass retained (g),Percent retained,"Cumulative percent retained",Percent passing
10,2.00,0.0,0.0,0.0,100.0
18,1.00,120.5,10.0,10.0,90.0
35,0.500,"1,024.0",85.0,95.0,5.0
60,0.250,60.1,5.0,100.0,0.0
Pan,,0.0,0.0,100.0,
Total,,"1,204.6",100.0,,
D50 (mm),0.72,,,,
"""
# Of a mesh's number, mean size and tare the widths are told apart; the pan is named where the number stands.
NUMBERED = """Sieve No.,Sieve opening in µm,Mean size (mm),Weight of sieve (g),Sieve + soil (g),Soil retained (g),Finer (%)
4,4750,,500.1,500.1,0,100
10,2000,3.4,480,530,50,75
20,850,1.4,450,550,100,25
Pan,-,,400,450,50,0
"""
REMARKS = "Sieve (mm);Mass retained (g);Remarks\n2;0;\n1;60;\n0,5;40;damp\nPan;0;\nTested by: Miller\n"
CLASSES = "Korngröße\tAnteil\nµm\tGew.-%\n63 - 125\t20,0\n125 – 250\t80,0\n"
PLAIN = "Maschenweite [mm];Rückstand [%]\n4;0\n2;40\n1;60\n"


@pytest.fixture
def read(tmp_path, capsys):
    def read(text, encoding="utf-8", **options):
        path = tmp_path / "lab.csv"
        path.write_bytes(text if isinstance(text, bytes) else text.encode(encoding))
        table = rs.size_table(path, **options)
        assert capsys.readouterr().err == table.understood + "\n" and "\n" not in table.understood
        return table
    return read


@pytest.mark.parametrize("encoding", ("latin-1", "utf-8", "utf-8-sig", "utf-16"))
def test_a_german_table(read, encoding):
    table = read(GERMAN, encoding)
    assert table == {"distribution": "table", "by": "mass", "radii": [0.001, 0.00118, 0.0014, 0.001575, 0.002],
                     "weights": pytest.approx([100.0 * part / 249.8 for part in (21.0, 50.5, 79.5, 67.8, 31.0)])}
    assert table.understood.endswith(
        'lab.csv: 5 meshes, "Maschenweite [mm]"; what each mesh retains from "Rückstand [g]", as "Durchgang [%]" says; '
        "diameters 2 to 4 mm; 8.41 % pass the finest mesh and are taken to be as wide as it")


def test_an_english_table(read):
    table = read(ENGLISH)
    assert table["radii"] == [0.000125, 0.00025, 0.0005, 0.001]
    assert table["weights"] == pytest.approx([0.0, 100 * 60.1 / 1204.6, 100 * 1024.0 / 1204.6, 100 * 120.5 / 1204.6])
    assert '"Percent retained" and "Cumulative percent retained" and "Percent passing" say' in table.understood


@pytest.mark.parametrize("column, weights", (
    ("Rückstand [%]", (0, 40, 60)), ("Rückstandssumme [%]", (0, 40, 100)), ("Durchgang [%]", (100, 60, 0)),
    ("Auswaage / g", (0, "20,0", "30,0")), ("Cum. mass retained (g)", (0, 20, 50)),
))
def test_every_way_to_say_it_is_the_same(read, column, weights):
    text = f"Maschenweite [mm];{column}\n" + "".join(f"{width};{weight}\n" for width, weight in zip((4, 2, 1), weights))
    table = read(text + f"Auffangschale;{50 if column.startswith('Cum') else '-'}\n")
    assert table["radii"] == [0.0005, 0.001, 0.002] and table["weights"] == [0.0, 60.0, 40.0]


def test_other_columns_are_left_alone(read):
    table = read(NUMBERED)
    assert table["radii"] == [0.000425, 0.001, 0.002375] and table["weights"] == [25.0, 50.0, 25.0]
    assert '"Soil retained (g)", as "Finer (%)" says' in table.understood


def test_classes_end_where_the_next_begins_and_units_may_have_a_line(read):
    table = read(CLASSES)
    assert table["radii"] == [3.15e-5, 6.25e-5, 1.25e-4] and table["weights"] == [0.0, 20.0, 80.0]
    with pytest.raises(ValueError, match=r'lab.csv:3: column "Korngröße µm": the class up to 0.1 mm does not end where'):
        read(CLASSES.replace("63 - 125", "63 - 100"))


def test_the_ends_may_be_given(read):
    with pytest.raises(ValueError, match=r'column "Rückstand \[g\]": 12.4 % do not pass the widest mesh, 3.15 mm: how'):
        read(GERMAN.replace("4,000;412,3;412,3;0,0;100,0\n", ""))
    table = read(GERMAN.replace("4,000;412,3;412,3;0,0;100,0\n", ""), largest=0.005, smallest=0.001)
    assert table["radii"][0] == 0.0005 and table["radii"][-1] == 0.0025 and table["weights"][0] == 0.0
    assert read(REMARKS)["weights"] == [0.0, 40.0, 60.0]
    fine = PLAIN.replace("40", "0").replace("60", "0") + "Boden;100\n"
    with pytest.raises(ValueError, match=r'column "Rückstand \[%\]": all pass the finest mesh, 1 mm: how small'):
        read(fine)
    assert read(fine, smallest=0.0005) == {"distribution": "table", "radii": [0.00025, 0.0005], "weights": [0.0, 100.0],
                                           "by": "mass"}
    for name, value in (("largest", 0.001), ("smallest", 0.003), ("smallest", 0), ("largest", float("nan")),
                        ("largest", "4")):
        with pytest.raises(ValueError, match=f"{name} = '?{value}'?: must be "):
            read(GERMAN, **{name: value})


def test_the_disks_of_a_scene_have_these_masses(read):
    size = read(GERMAN)
    species = {"name": "pet", "count": 20000, "radius": 0.0014, "mass": 1e-6, "size": {**size, "mass_exponent": 2}}
    disks = rs.Simulation(rs.Scene({"base": {"teeth": 100}, "species": [species],
                                    "contact": {"pair_collisions": False}})).disks
    masses, _ = np.histogram(disks["radius"], [0.0, 0.0010000001, *size["radii"][1:]], weights=disks["mass"])
    assert 100.0 * masses / masses.sum() == pytest.approx(size["weights"], rel=0.1)


@pytest.mark.parametrize("text, message", (
    (PLAIN.replace("[mm]", ""), r'column "Maschenweite": has no unit: must be mm or µm'),
    (PLAIN.replace(" [%]", ""), r'column "Rückstand": has no unit: must be g or %'),
    (PLAIN.replace("Rückstand", "Probe 1"), r'column "Probe 1 \[%\]": is it what each mesh retains, that summed up'),
    (PLAIN.replace("2;40", "2;100").replace("1;60", "1;100"), r'column "Rückstand \[%\]": sums to 200 %: must be 100'),
    (PLAIN.replace("2;40", "2;30"), r'column "Rückstand \[%\]": sums to 90 %: must be 100; is the pan missing'),
    (PLAIN.replace("2;40", "2;"), r'lab.csv:3: column "Rückstand \[%\]": has no value at 2 mm'),
    (PLAIN.replace("2;40", "2;-40"), r'lab.csv:3: column "Rückstand \[%\]": "-40" is no number from 0 on'),
    (PLAIN.replace("2;40", "2;4e1"), r'lab.csv:3: column "Rückstand \[%\]": "4e1" is no number'),
    (PLAIN.replace("2;40", "2;n.b."), r'lab.csv:3: column "Rückstand \[%\]": "n.b." is no number'),
    (PLAIN.replace("2;40", "2.0;40,0"), r'lab.csv:3: column "Maschenweite \[mm\]": "2.0" is no number from 0 on with '
                                        "decimal commas"),
    (PLAIN.replace("2;40", "2;40;7"), r'lab.csv:3: column "Maschenweite \[mm\]": its line has 3 cells, that of the '
                                      "names has 2"),
    (PLAIN.replace("4;0", "2;0"), r'lab.csv:3: column "Maschenweite \[mm\]": 2 mm is there twice'),
    (PLAIN + "Boden;0\nPan;0\n", r'lab.csv:6: column "Maschenweite \[mm\]": the pan is there twice'),
    (PLAIN.replace("2;40", "zwei;40"), r'lab.csv:3: column "Maschenweite \[mm\]": "zwei" is no mesh width, pan or sum'),
    (PLAIN.replace("4;0\n2;40\n1;60", "4;0"), r'column "Maschenweite \[mm\]": must have two mesh widths or more'),
    (PLAIN.replace("Rückstand", "Durchgang"), r'column "Durchgang \[%\]": must fall from mesh to finer mesh'),
    (PLAIN.replace("[%]", "[g]").replace("40", "0").replace("60", "0"), r'column "Rückstand \[g\]": retains nothing'),
    (PLAIN.replace("Rückstand [%]", "Durchgang [g]"), r'column "Durchgang \[g\]": must be in %'),
    (PLAIN.replace("Rückstand [%]", "Sieböffnung [mm]"), "lab.csv: no line with the name of a column of mesh widths"),
    ("Mesh (mm);Aperture (µm);Retained (g)\n1;1000;3\n2;2000;0\n", r'column "Aperture \(µm\)": is one of mesh widths, as'),
    (GERMAN.replace("60,4", "55,4"), r'column "Durchgang \[%\]": differs from "Rückstand \[g\]" by 5.06 % of the mass'),
    ("1;2\n3;4\n", "lab.csv: no line with the name"), ("", "lab.csv: no line with the name"),
    (b"PK\x03\x04\0\0", "lab.csv: is no text: save the table as CSV"),
    (b"\xff\xfe\xd8\xd8", "lab.csv: no line"), (b"x" * 200_000, "lab.csv: is no table: field larger than"),
    (b";" * (1 << 21), "lab.csv: is larger than any sieve analysis"),
    ("Mesh (mm);Retained (g)\n" + "9" * 400 + ";1\n1;0\n", "is too large"), ("Mesh (mm);Retained (g)\n1,2,3;1\n1;0\n", "no number"),
), ids=lambda value: str(value)[:40])
def test_what_is_not_clear_is_refused(read, text, message):
    with pytest.raises(ValueError, match=message) as error:
        read(text)
    assert "\n" not in str(error.value)


def test_of_columns_that_differ_one_is_chosen(read):
    text = "Mesh (mm),Sample 1 (g),Sample 2 (g)\n4,0,0\n2,10,20\n1,10,0\n"
    with pytest.raises(ValueError, match=r'column "Sample 2 \(g\)": differs from "Sample 1 \(g\)" by 50 %'):
        read(text)
    assert read(text, column="Sample 2 (g)")["weights"] == [0.0, 100.0]
    with pytest.raises(ValueError, match='and that of "Sample 3"'):
        read(text, column="Sample 3")


def test_a_file_that_is_not_there_is_an_error(tmp_path):
    with pytest.raises(FileNotFoundError):
        rs.size_table(tmp_path / "none.csv")
