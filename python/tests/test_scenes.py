# SPDX-License-Identifier: MIT
"""Scenes from files, texts, dicts and objects, and their errors."""

from pathlib import Path

import numpy as np
import pytest
from small_scenes import column

import freshet


def test_a_dict_and_an_object_are_the_same_scene():
    scene = freshet.Scene(
        domain=freshet.Domain(max=[1.0, 0.6]),
        particles=freshet.Particles(spacing=0.04),
        fluid=[freshet.Fluid(min=(0.0, 0.0), max=np.array([0.3, 0.5]))],
        solver=freshet.Solver(name="wcsph", sound_speed=20.0),
        time=freshet.Time(end=1.0, step=0.0005),
    )
    first, second = freshet.Simulation(scene), freshet.Simulation(column())
    first.step(20)
    second.step(20)
    assert first.state_sha256() == second.state_sha256()


def test_keys_that_are_words_of_python():
    probe = freshet.ProbeSection(kind="line", from_=[0.1, 0.1], to=[0.2, 0.1])
    assert probe.to_dict() == {"kind": "line", "from": [0.1, 0.1], "to": [0.2, 0.1]}
    freshet.check(column(probe=[probe]))


def test_classes_know_their_keys():
    with pytest.raises(TypeError, match="spacin"):
        freshet.Particles(spacin=0.1)
    particles = freshet.Particles(spacing=0.1)
    with pytest.raises(AttributeError, match="Particles has no key spacin"):
        particles.spacin = 0.2
    source = Path(freshet.scene_classes.__file__).read_text(encoding="utf-8")
    assert "distance of neighbours" in source
    assert repr(particles) == "Particles(spacing=0.1)"


def test_every_key_of_the_schema_is_in_the_classes():
    import json

    from freshet import _freshet, scene_classes

    schema = json.loads(_freshet.scene_schema())
    assert len(schema["properties"]) > 15
    for key in schema["properties"]:
        assert key in scene_classes.Scene.__dataclass_fields__
    solver = schema["properties"]["solver"]["properties"]
    assert set(solver) == set(scene_classes.Solver.__dataclass_fields__)


def test_an_error_has_file_line_key_and_remedy(tmp_path):
    file = tmp_path / "wrong.toml"
    file.write_text(freshet.to_toml(column(particles={"spacing": -1.0})))
    with pytest.raises(freshet.Error) as caught:
        freshet.Simulation(file)
    error = caught.value
    assert error.kind == "scene"
    assert error.file == str(file)
    assert file.read_text().splitlines()[error.line - 1] == "spacing = -1.0"
    assert error.column == 11
    assert error.key == "particles.spacing"
    assert error.message.startswith("particles.spacing is -1")
    assert error.remedy == "it must be a number > 0 (m)"
    assert str(error).startswith(f"{file}:{error.line}:11: error: particles.spacing is -1")


def test_all_errors_come_at_once_and_name_the_key_of_set():
    scene = column(solver={"name": "wcsph", "sound_sped": 20.0})
    with pytest.raises(freshet.Error) as caught:
        freshet.check(scene, set={"particles.spacing": 0.0, "time.end": "soon"})
    keys = [d.key for d in caught.value.diagnostics]
    assert {"particles.spacing", "time.end", "solver.sound_sped"} <= set(keys)
    assert "did you mean solver.sound_speed?" in str(caught.value)
    assert "set particles.spacing: error:" in str(caught.value)


def test_set_replaces_and_removes_keys():
    checked = freshet.check(column(title="A column"), set={"title": None, "time.end": 0.5})
    assert checked.title == "" and checked.end == 0.5
    with pytest.raises(freshet.Error, match="nothing"):
        freshet.check(column(), set={"nothing.here": None})


def test_toml_of_all_kinds_of_values():
    text = freshet.to_toml(
        {
            "title": 'quotes " and \\ and ü\n',
            "a": {"n": np.float32(0.5), "k": np.int64(3), "b": True, "skip": None},
            "list": [{"x": np.arange(2)}, {"x": []}],
        }
    )
    import tomllib

    assert tomllib.loads(text) == {
        "title": 'quotes " and \\ and ü\n',
        "a": {"n": 0.5, "k": 3, "b": True},
        "list": [{"x": [0, 1]}, {"x": []}],
    }
    with pytest.raises(TypeError, match="has no form in TOML"):
        freshet.to_toml({"a": object()})


def test_bundled_scenes_are_found_by_name():
    assert "dam_break_2d" in freshet.bundled_scenes()
    assert freshet.check("dam_break_2d").dimension == 2
    with pytest.raises(freshet.Error, match="did you mean dam_break_2d[?] bundled: article"):
        freshet.check("dam_brake_2d")
    with pytest.raises(freshet.Error, match="no bundled scene of that name; bundled: article"):
        freshet.check("zzz")
    with pytest.raises(TypeError, match="a scene is a file, .*, not None"):
        freshet.check(None)
    assert (freshet.data_folder("validation") / "dam_break_front").is_dir()
    with pytest.raises(freshet.Error, match="no such folder is installed"):
        freshet.data_folder("nothing")


def test_warnings_of_a_valid_scene():
    checked = freshet.check(column(time={"end": 1.0, "step": 0.01}))
    warnings = freshet.warnings_of(checked)
    assert warnings and all(w.severity == "warning" for w in warnings)
    assert any("0.01" in w.message for w in warnings), warnings
    assert checked.derived["particles"] == 8 * 13
