// SPDX-License-Identifier: MIT
#pragma once
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "draw/gl.h"
#include "view/camera.h"
#include "view/shapes.h"

namespace freshet::gl {

/// The first lines of every shader: OpenGL 3.3, or OpenGL ES 3.0 and WebGL 2.
std::string_view shader_prefix();

/// A linked pair of shaders. Throws Error (kind run) with the compiler's words.
class Program {
 public:
  Program(const char* name, std::string_view vertex, std::string_view fragment);
  ~Program();
  Program(const Program&) = delete;

  void use() const { glUseProgram(id_); }
  // Uniforms; the program must be in use.
  void set(const char* name, int value) const { glUniform1i(at(name), value); }
  void set(const char* name, float value) const { glUniform1f(at(name), value); }
  void set(const char* name, float x, float y) const { glUniform2f(at(name), x, y); }
  void set(const char* name, float x, float y, float z) const { glUniform3f(at(name), x, y, z); }
  void set(const char* name, const view::Tint& c) const {
    glUniform4f(at(name), c.r, c.g, c.b, c.a);
  }
  void set(const char* name, const view::Matrix& m) const {
    glUniformMatrix4fv(at(name), 1, GL_FALSE, m.data());
  }
  /// Binds a texture to a unit and the uniform to it.
  void set_texture(const char* name, int unit, GLuint texture) const;

 private:
  GLint at(const char* name) const;

  GLuint id_;
  mutable std::map<std::string, GLint, std::less<>> places_;
};

/// Vertices of floats, `sizes` numbers for each attribute in turn.
class Vertices {
 public:
  explicit Vertices(const std::vector<int>& sizes);
  ~Vertices();
  Vertices(Vertices&& other) noexcept;
  Vertices& operator=(Vertices&&) = delete;

  void fill(const std::vector<float>& numbers);
  int count() const { return count_; }
  void draw(GLenum mode) const;

 private:
  GLuint array_ = 0, buffer_ = 0;
  int stride_ = 0, count_ = 0;
};

/// A texture that is drawn into, with a depth of its own.
class Target {
 public:
  /// `format`: GL_RGBA8, GL_R32F or GL_R16F.
  explicit Target(GLenum format) : format_(format) {}
  ~Target();
  Target(const Target&) = delete;

  /// Makes it of this size; its content is lost if the size changes. Throws Error (kind run) if the
  /// graphics driver cannot draw into such a texture.
  void resize(int width, int height);
  /// Draws into it from now on.
  void bind() const;
  GLuint color() const { return color_; }
  GLuint depth() const { return depth_; }
  int width() const { return width_; }
  int height() const { return height_; }

 private:
  void release();

  GLenum format_;
  GLuint frame_ = 0, color_ = 0, depth_ = 0;
  int width_ = 0, height_ = 0;
};

}  // namespace freshet::gl
