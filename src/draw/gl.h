// SPDX-License-Identifier: MIT
/// The functions of OpenGL 3.3 that are drawn with. They exist in OpenGL ES 3.0 and WebGL 2, too.
#pragma once

#ifdef __EMSCRIPTEN__
#include <GLES3/gl3.h>
#else
#include <GL/glcorearb.h>
#endif

// name, type of its pointer
#define FRESHET_GL_FUNCTIONS(F)                       \
  F(ActiveTexture, ACTIVETEXTURE)                     \
  F(AttachShader, ATTACHSHADER)                       \
  F(BindBuffer, BINDBUFFER)                           \
  F(BindFramebuffer, BINDFRAMEBUFFER)                 \
  F(BindTexture, BINDTEXTURE)                         \
  F(BindVertexArray, BINDVERTEXARRAY)                 \
  F(BlendFunc, BLENDFUNC)                             \
  F(BufferData, BUFFERDATA)                           \
  F(CheckFramebufferStatus, CHECKFRAMEBUFFERSTATUS)   \
  F(Clear, CLEAR)                                     \
  F(ClearColor, CLEARCOLOR)                           \
  F(CompileShader, COMPILESHADER)                     \
  F(CreateProgram, CREATEPROGRAM)                     \
  F(CreateShader, CREATESHADER)                       \
  F(DeleteBuffers, DELETEBUFFERS)                     \
  F(DeleteFramebuffers, DELETEFRAMEBUFFERS)           \
  F(DeleteProgram, DELETEPROGRAM)                     \
  F(DeleteShader, DELETESHADER)                       \
  F(DeleteTextures, DELETETEXTURES)                   \
  F(DeleteVertexArrays, DELETEVERTEXARRAYS)           \
  F(DepthMask, DEPTHMASK)                             \
  F(Disable, DISABLE)                                 \
  F(DrawArrays, DRAWARRAYS)                           \
  F(Enable, ENABLE)                                   \
  F(EnableVertexAttribArray, ENABLEVERTEXATTRIBARRAY) \
  F(Finish, FINISH)                                   \
  F(FramebufferTexture2D, FRAMEBUFFERTEXTURE2D)       \
  F(GenBuffers, GENBUFFERS)                           \
  F(GenFramebuffers, GENFRAMEBUFFERS)                 \
  F(GenTextures, GENTEXTURES)                         \
  F(GenVertexArrays, GENVERTEXARRAYS)                 \
  F(GetProgramInfoLog, GETPROGRAMINFOLOG)             \
  F(GetProgramiv, GETPROGRAMIV)                       \
  F(GetShaderInfoLog, GETSHADERINFOLOG)               \
  F(GetShaderiv, GETSHADERIV)                         \
  F(GetString, GETSTRING)                             \
  F(GetUniformLocation, GETUNIFORMLOCATION)           \
  F(LinkProgram, LINKPROGRAM)                         \
  F(PixelStorei, PIXELSTOREI)                         \
  F(ReadPixels, READPIXELS)                           \
  F(ShaderSource, SHADERSOURCE)                       \
  F(TexImage2D, TEXIMAGE2D)                           \
  F(TexParameteri, TEXPARAMETERI)                     \
  F(Uniform1f, UNIFORM1F)                             \
  F(Uniform1i, UNIFORM1I)                             \
  F(Uniform2f, UNIFORM2F)                             \
  F(Uniform3f, UNIFORM3F)                             \
  F(Uniform4f, UNIFORM4F)                             \
  F(UniformMatrix4fv, UNIFORMMATRIX4FV)               \
  F(UseProgram, USEPROGRAM)                           \
  F(VertexAttribPointer, VERTEXATTRIBPOINTER)         \
  F(Viewport, VIEWPORT)

namespace freshet::gl {

#ifndef __EMSCRIPTEN__
// Within this namespace, so that they are not taken for the symbols of the system's library.
#define FRESHET_GL_DECLARE(name, type) extern PFNGL##type##PROC gl##name;
FRESHET_GL_FUNCTIONS(FRESHET_GL_DECLARE)
#undef FRESHET_GL_DECLARE
#endif

/// Finds the functions of the current context by `find`. Returns the name of one that is missing,
/// or null.
const char* load_gl(void* (*find)(const char* name));

}  // namespace freshet::gl
