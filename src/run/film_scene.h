// SPDX-License-Identifier: MIT
/// The files that integrations/blender reads. docs/film.md describes them.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "freshet/frame.h"
#include "freshet/scene.h"
#include "run/film_materials.h"
#include "run/film_view.h"

namespace freshet {

struct FilmPicture {
  int width, height, samples;
  double shutter;  ///< seconds of motion in a picture
  bool denoise;
};

/// What a film's frames share.
struct FilmLook {
  FilmPicture picture;
  FilmView view;
  FilmMaterials materials;
};

inline constexpr const char* film_scene_file = "scene.json";
/// Such as "frame_0007.json".
std::string film_frame_file(std::int64_t number);
/// Such as "liquid0_0007.glb".
std::string film_surface_file(std::size_t liquid, std::int64_t number);

/// Such as "whitewater_0007.ply".
std::string film_whitewater_file(std::int64_t number);

/// scene.json: everything that is the same in all frames.
std::string encode_film_scene(const Scene& scene, const FilmLook& look);
/// The meshes that scene.json names, by their file names: bodies about their centres of mass, and
/// walls that are in the domain. Infinite planes and walls around the fluid are excluded.
std::map<std::string, std::string> encode_film_solids(const Scene& scene);
/// frame_0007.json: time, surfaces, whitewater, camera and poses of the bodies. `number` is that of
/// the data file.
std::string encode_film_frame(const Scene& scene, const Frame& frame, std::int64_t number,
                              const FilmView& view);

}  // namespace freshet
