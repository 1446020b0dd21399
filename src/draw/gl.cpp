// SPDX-License-Identifier: MIT
#include "draw/gl.h"

namespace freshet::gl {

#ifdef __EMSCRIPTEN__
const char* load_gl(void* (*)(const char*)) { return nullptr; }
#else
#define FRESHET_GL_DEFINE(name, type) PFNGL##type##PROC gl##name = nullptr;
FRESHET_GL_FUNCTIONS(FRESHET_GL_DEFINE)
#undef FRESHET_GL_DEFINE

const char* load_gl(void* (*find)(const char* name)) {
#define FRESHET_GL_FIND(name, type)                                 \
  gl##name = reinterpret_cast<PFNGL##type##PROC>(find("gl" #name)); \
  if (!gl##name) return "gl" #name;
  FRESHET_GL_FUNCTIONS(FRESHET_GL_FIND)
#undef FRESHET_GL_FIND
  return nullptr;
}
#endif

}  // namespace freshet::gl
