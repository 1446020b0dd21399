// SPDX-License-Identifier: MIT
/// The files that integrations/blender/render_film.py reads. docs/film.md describes them.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "freshet/frame.h"
#include "freshet/scene.h"

namespace freshet {

struct FilmPicture {
  int width, height, samples;
};

inline constexpr const char* film_scene_file = "scene.json";
/// Such as "frame_0007.json".
std::string film_frame_file(std::int64_t number);
/// Such as "liquid0_0007.glb".
std::string film_surface_file(std::size_t liquid, std::int64_t number);

/// scene.json: everything that is the same in all frames.
std::string encode_film_scene(const Scene& scene, const FilmPicture& picture);
/// The meshes that scene.json names, by their file names: bodies about their centres of mass, and
/// walls that are in the domain. Infinite planes and walls around the fluid are excluded.
std::map<std::string, std::string> encode_film_solids(const Scene& scene);
/// frame_0007.json: time, surfaces, camera and poses of the bodies.
std::string encode_film_frame(const Scene& scene, const Frame& frame, std::int64_t number);

}  // namespace freshet
