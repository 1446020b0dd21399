// SPDX-License-Identifier: MIT
// The functions that the page calls. Texts are UTF-8 with a zero at the end; a returned text and a
// returned array are valid until the next call. After a failure freshet_message() is the error.
#include <algorithm>
#include <memory>
#include <new>
#include <string>

#include "core/sha256.h"
#include "web/module/session.h"

#define FRESHET_EXPORT extern "C"

namespace {

using freshet::web::Request;
using freshet::web::Session;

std::unique_ptr<Session> session;
std::string message, text;

const char* keep(std::string value) {
  text = std::move(value);
  return text.c_str();
}

/// Calls f; 0 and the message if it throws.
template <class F> int guarded(const F& f) {
  try {
    return f();
  } catch (const freshet::Error& e) {
    message = freshet::web::lines_of(e.diagnostics());
  } catch (const std::bad_alloc&) {
    message = "error: out of memory; use fewer particles\n";
  } catch (const std::exception& e) {
    message = std::string("error: ") + e.what() + "\n";
  }
  return 0;
}

}  // namespace

/// Opens a scene: 1, or 0 after an error. The open scene then stays. With `keep` the particles stay
/// where they are in the open scene, if it has as many.
FRESHET_EXPORT int freshet_open(const char* scene, const char* name, const char* solver,
                                const char* changes, int keep) {
  return guarded([&] {
    auto opened = std::make_unique<Session>(Request{scene, name, solver, changes});
    if (keep && session) opened->take_particles(*session);
    session = std::move(opened);
    return 1;
  });
}

/// Checks a scene and opens nothing: 1 and its warnings, or 0 and its errors, as the message.
FRESHET_EXPORT int freshet_check(const char* scene, const char* name, const char* solver,
                                 const char* changes) {
  return guarded([&] {
    std::vector<freshet::Diagnostic> warnings;
    freshet::web::scene_of({scene, name, solver, changes}, warnings);
    message = freshet::web::lines_of(warnings);
    return 1;
  });
}

FRESHET_EXPORT const char* freshet_message() { return message.c_str(); }

/// Takes at most so many steps, for about so many milliseconds, and with `past_end` beyond the end
/// of the scene: 1, or 0 after an error.
FRESHET_EXPORT int freshet_step(int steps, double milliseconds, int past_end) {
  return guarded([&] {
    session->step(steps, milliseconds, past_end != 0);
    return 1;
  });
}

/// Pushes the fluid around a place [m] until the next call; an acceleration of 0 ends it.
FRESHET_EXPORT void freshet_push(double x, double y, double z, double ax, double ay, double az,
                                 double radius) {
  session->push({{x, y, z}, {ax, ay, az}, radius});
}
FRESHET_EXPORT int freshet_set_gravity(double x, double y, double z) {
  return guarded([&] {
    freshet::Vector gravity{x, y};
    if (session->simulation().scene().dimension() == 3) gravity.push_back(z);
    session->set_gravity(gravity);
    return 1;
  });
}

FRESHET_EXPORT const char* freshet_about() { return keep(session->about()); }
FRESHET_EXPORT const char* freshet_state() { return keep(session->state()); }
FRESHET_EXPORT const char* freshet_state_sha256() {
  return keep(session->simulation().state_sha256());
}

/// What is drawn now, coloured by a quantity (the number of a ColorBy).
FRESHET_EXPORT const freshet::view::Shown* freshet_update(int quantity) {
  return &session->update(freshet::ColorBy(quantity));
}

namespace {

const std::vector<float>& array_of(const freshet::view::Shown& shown, int array) {
  const std::vector<float>* arrays[] = {&session->packed_stage(), &shown.balls, &shown.foam,
                                        &shown.placements};
  return *arrays[array];
}

}  // namespace

/// An array of it: 0 the packed stage, 1 balls, 2 foam, 3 placements.
FRESHET_EXPORT int freshet_array_size(const freshet::view::Shown* shown, int array) {
  return int(array_of(*shown, array).size());
}
FRESHET_EXPORT const float* freshet_array(const freshet::view::Shown* shown, int array) {
  return array_of(*shown, array).data();
}
/// Its colours: RGBA.
FRESHET_EXPORT const std::uint8_t* freshet_map(const freshet::view::Shown* shown) {
  return shown->map.data();
}
FRESHET_EXPORT int freshet_map_size(const freshet::view::Shown* shown) {
  return int(shown->map.size());
}

/// The picture of a 2D scene as a run writes it, without texts: RGB, rows from the top.
FRESHET_EXPORT const void* freshet_picture() { return session->picture().pixels.data(); }
FRESHET_EXPORT int freshet_picture_width() { return session->picture().width; }
FRESHET_EXPORT int freshet_picture_height() { return session->picture().height; }
/// SHA-256 over these bytes.
FRESHET_EXPORT const char* freshet_picture_sha256() {
  freshet::Sha256 sha;
  sha.add(session->picture().pixels.data(), 3 * session->picture().pixels.size());
  return keep(sha.hex());
}
FRESHET_EXPORT const char* freshet_picture_pixels() { return keep(session->picture_pixels()); }
