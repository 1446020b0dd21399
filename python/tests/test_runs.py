# SPDX-License-Identifier: MIT
"""Run folders: written, opened, plotted; sweeps."""

import subprocess
import sys

import numpy as np
import pytest
from small_scenes import column, floating

import freshet
from freshet import plots


@pytest.fixture(scope="module")
def run(tmp_path_factory):
    scene = floating()
    scene["title"] = "A box on water"
    scene["time"] = {"end": 0.1, "step": 0.0005}
    scene["output"] = {"frame_every": 0.05, "observables_every": 0.01}
    scene["probe"] = [{"kind": "surface", "name": "gauge", "from": [0.1, 0.0], "to": [0.1, 0.6]}]
    return freshet.run(scene, tmp_path_factory.mktemp("runs") / "box", threads=1)


def test_frames(run):
    assert len(run.frames) == 3
    last = run.frames[-1]
    assert last.time == pytest.approx(0.1) and last.x.shape == (len(last), 2)
    assert [f.time for f in run.frames[:2]] == [0, pytest.approx(0.05)]
    assert len(list(run)) == 3 and len(last.bodies) == 1
    with pytest.raises(IndexError, match="no frame 3; the run has 3"):
        run.frames[3]
    simulation = freshet.Simulation(run.scene, threads=1)
    simulation.run()
    assert simulation.state_sha256() == run.report["state_sha256"]
    assert (simulation.frame().x == last.x).all()


def test_tables(run):
    table = run.observables
    assert table.rows == 11 and table.units["speed max"] == "m/s"
    assert table["time"][-1] == pytest.approx(0.1)
    assert table["ruled by"][-1] == "fixed"
    assert run.probes["gauge"]["distance"].shape == table["time"].shape
    assert run.bodies["box"]["y"][0] == pytest.approx(0.4)
    assert "speed p99" in run.percentiles
    with pytest.raises(KeyError, match="no column 'sped'; columns: step"):
        table["sped"]
    assert "speed max [m/s]" in table._repr_html_()


def test_tables_with_comments_quotes_and_an_unfinished_line(tmp_path):
    file = tmp_path / "t.csv"
    file.write_text('# a comment\ntime [s],"a, b [m]",word\n0,1,x\n1,,y\n2,3')
    table = freshet.read_table(file)
    assert list(table) == ["time", "a, b", "word"] and table.rows == 2
    assert np.isnan(table["a, b"][1]) and list(table["word"]) == ["x", "y"]
    assert table.where(table["word"] == "y")["time"].tolist() == [1]


def test_pandas(run):
    pandas = pytest.importorskip("pandas", reason="pandas is not installed")
    frame = run.observables.to_pandas()
    assert isinstance(frame, pandas.DataFrame) and frame["speed max [m/s]"].max() > 0


def test_plots(run, tmp_path):
    pytest.importorskip("matplotlib", reason="matplotlib is not installed")
    figure = run.plot("speed max", "gauge: distance", "y", against=[run])
    assert [a.get_ylabel() for a in figure.axes] == ["speed max [m/s]", "[m]"]
    assert len(figure.axes[1].lines) == 4
    picture = plots.png_of(figure)
    assert picture.startswith(b"\x89PNG")
    with pytest.raises(freshet.Error, match="no column 'nothing' over time; columns: "):
        run.plot("nothing")
    drawn = run.draw(-1, color_by="pressure")
    assert len(drawn.axes[0].collections[0].get_offsets()) == len(run.frames[-1])
    assert drawn._repr_png_().startswith(b"\x89PNG")
    many = run.plot("speed max", against=[run] * 5)
    assert len(many.axes[0].lines) == 6
    assert len(run.draw(color_by="liquid").axes[0].collections[0].get_array()) == len(run.frames[-1])
    with pytest.raises(ValueError, match="color_by is 'taste'"):
        run.draw(color_by="taste")


def test_notebooks_show_the_result(run):
    assert run._repr_png_() == (run.path / "result.png").read_bytes()


def test_a_folder_without_a_run(tmp_path):
    with pytest.raises(freshet.Error, match="no run is in this folder"):
        freshet.open_run(tmp_path)
    with pytest.raises(freshet.Error, match="nowhere: error: no such folder"):
        freshet.open_run(tmp_path / "nowhere")


def test_a_folder_is_not_replaced_unasked(tmp_path):
    scene = column(time={"end": 0.001, "step": 0.0005})
    first = freshet.run(scene, tmp_path / "twice")
    with pytest.raises(freshet.Error, match="this folder holds a run; `overwrite` replaces it"):
        freshet.run(scene, tmp_path / "twice")
    assert freshet.run(scene, tmp_path / "twice", overwrite=True).report["steps"] == 2
    (first.path / "report.json").unlink()
    with pytest.raises(freshet.Error, match="a run writes it at its end"):
        first.report


def front(simulation):
    return {"front": simulation.x[:, 0].max(), "time": simulation.time}


def test_a_sweep_in_this_process():
    table = freshet.sweep(
        column(),
        {"solver.artificial_viscosity": [0.05, 1.0], "domain.gravity": [[0.0, -9.81], [0.0, -1.0]]},
        front,
        until=0.2,
        processes=1,
    )
    assert table.rows == 4 and list(table)[-2:] == ["front", "time"]
    assert table["domain.gravity"].shape == (4, 2) and "<td>[0.0, -1.0]</td>" in table._repr_html_()
    fronts = table["front"]
    assert fronts[0] > fronts[2] and fronts[0] > fronts[1]
    with pytest.raises(freshet.Error, match="set solver.artificial_viscosity"):
        freshet.sweep(column(), {"solver.artificial_viscosity": [0.1, -1.0]}, front, processes=1)


SWEEP = f"""
import freshet
scene = {column()!r}
def front(sim):
    return {{"front": sim.x[:, 0].max()}}
def main():
    table = freshet.sweep(scene, {{"solver.artificial_viscosity": [0.05, 1.0]}}, front, until=0.1, processes=2)
    print(table["front"].tolist())
"""


def test_errors_of_a_sweep():
    def swept(parameters, measure=front, **keys):
        return freshet.sweep(column(), parameters, measure, until=0.5, **{"processes": 1, **keys})

    with pytest.raises(freshet.Error, match="time.step = 0.05: error: particle"):
        swept({"time.step": [0.05]})
    with pytest.raises(TypeError, match=r"parameters\['time.step'\] is 0.05; it must be a list"):
        swept({"time.step": 0.05})
    with pytest.raises(ValueError, match="is empty"):
        swept({"time.step": []})
    with pytest.raises(TypeError, match="measure returned 1; it must return a dict"):
        swept({"time.step": [0.0005]}, lambda s: 1)
    with pytest.raises(ValueError, match="other processes cannot import <function .*<lambda>"):
        swept({"time.step": [0.0004, 0.0005]}, lambda s: {}, processes=2)


@pytest.mark.parametrize(
    "arguments, message",
    [(["-c", SWEEP + "main()"], "other processes cannot import"), (["FILE"], "begin the work of a script below")],
)
def test_a_sweep_that_processes_cannot_import_ends(arguments, message, tmp_path):
    script = tmp_path / "unguarded.py"
    script.write_text(SWEEP + "main()\n")
    command = [sys.executable, *(script if a == "FILE" else a for a in arguments)]
    done = subprocess.run(command, capture_output=True, text=True, timeout=120)
    assert done.returncode != 0 and message in done.stderr


def test_a_sweep_in_processes(tmp_path):
    script = tmp_path / "sweep.py"
    script.write_text(SWEEP + "if __name__ == '__main__':\n    main()\n")
    done = subprocess.run([sys.executable, script], check=True, capture_output=True, text=True)
    alone = freshet.sweep(column(), {"solver.artificial_viscosity": [0.05, 1.0]}, front, until=0.1, processes=1)
    assert done.stdout.strip() == str(alone["front"].tolist())
