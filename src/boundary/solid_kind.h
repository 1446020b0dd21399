// SPDX-License-Identifier: MIT
#pragma once

namespace freshet {

/// A shape with a surface: a box, a ball (in 2D a disc), a cylinder or a half space.
enum class SolidKind { box, ball, cylinder, plane };

}  // namespace freshet
