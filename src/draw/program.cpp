// SPDX-License-Identifier: MIT
#include "draw/program.h"

#include <utility>

#include "freshet/error.h"

namespace freshet::gl {
namespace {

[[noreturn]] void fail(const std::string& what, const std::string& why) {
  throw Error(Error::Kind::run, "", what + ": " + why + "; update the graphics driver");
}

GLuint compile(GLenum kind, const char* name, std::string_view source) {
  const GLuint shader = glCreateShader(kind);
  const std::string text = std::string(shader_prefix()) + std::string(source);
  const char* lines = text.c_str();
  glShaderSource(shader, 1, &lines, nullptr);
  glCompileShader(shader);
  GLint ok = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
  if (!ok) {
    char log[1000] = {};
    glGetShaderInfoLog(shader, sizeof log - 1, nullptr, log);
    fail(std::string("the shader ") + name + " does not compile", log);
  }
  return shader;
}

}  // namespace

std::string_view shader_prefix() {
#ifdef __EMSCRIPTEN__
  return "#version 300 es\nprecision highp float;\nprecision highp int;\n"
         "precision highp sampler2D;\n";
#else
  return "#version 330 core\n";
#endif
}

Program::Program(const char* name, std::string_view vertex, std::string_view fragment)
    : id_(glCreateProgram()) {
  const GLuint shaders[] = {compile(GL_VERTEX_SHADER, name, vertex),
                            compile(GL_FRAGMENT_SHADER, name, fragment)};
  for (const GLuint shader : shaders) glAttachShader(id_, shader);
  glLinkProgram(id_);
  for (const GLuint shader : shaders) glDeleteShader(shader);
  GLint ok = 0;
  glGetProgramiv(id_, GL_LINK_STATUS, &ok);
  if (!ok) {
    char log[1000] = {};
    glGetProgramInfoLog(id_, sizeof log - 1, nullptr, log);
    fail(std::string("the shaders ") + name + " do not link", log);
  }
}

Program::~Program() { glDeleteProgram(id_); }

void Program::set_texture(const char* name, int unit, GLuint texture) const {
  glActiveTexture(GLenum(GL_TEXTURE0 + unit));
  glBindTexture(GL_TEXTURE_2D, texture);
  set(name, unit);
}

GLint Program::at(const char* name) const {
  const auto it = places_.find(name);
  if (it != places_.end()) return it->second;
  return places_[name] = glGetUniformLocation(id_, name);
}

Vertices::Vertices(const std::vector<int>& sizes) {
  for (const int size : sizes) stride_ += size;
  glGenVertexArrays(1, &array_);
  glGenBuffers(1, &buffer_);
  glBindVertexArray(array_);
  glBindBuffer(GL_ARRAY_BUFFER, buffer_);
  std::size_t offset = 0;
  for (std::size_t k = 0; k < sizes.size(); ++k) {
    glEnableVertexAttribArray(GLuint(k));
    glVertexAttribPointer(GLuint(k), sizes[k], GL_FLOAT, GL_FALSE, stride_ * int(sizeof(float)),
                          reinterpret_cast<const void*>(offset * sizeof(float)));
    offset += std::size_t(sizes[k]);
  }
}

Vertices::~Vertices() {
  if (array_) glDeleteVertexArrays(1, &array_);
  if (buffer_) glDeleteBuffers(1, &buffer_);
}

Vertices::Vertices(Vertices&& other) noexcept
    : array_(std::exchange(other.array_, 0)),
      buffer_(std::exchange(other.buffer_, 0)),
      stride_(other.stride_),
      count_(other.count_) {}

void Vertices::fill(const std::vector<float>& numbers) {
  count_ = int(numbers.size()) / stride_;
  glBindBuffer(GL_ARRAY_BUFFER, buffer_);
  glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(numbers.size() * sizeof(float)), numbers.data(),
               GL_STREAM_DRAW);
}

void Vertices::draw(GLenum mode) const {
  if (count_ == 0) return;
  glBindVertexArray(array_);
  glDrawArrays(mode, 0, count_);
}

Target::~Target() { release(); }

void Target::release() {
  if (frame_) glDeleteFramebuffers(1, &frame_);
  if (color_) glDeleteTextures(1, &color_);
  if (depth_) glDeleteTextures(1, &depth_);
  frame_ = color_ = depth_ = 0;
}

void Target::resize(int width, int height) {
  if (width == width_ && height == height_ && frame_) return;
  release();
  width_ = width;
  height_ = height;
  const auto texture = [&](GLenum inside, GLenum format, GLenum type) {
    GLuint t = 0;
    glGenTextures(1, &t);
    glBindTexture(GL_TEXTURE_2D, t);
    glTexImage2D(GL_TEXTURE_2D, 0, GLint(inside), width, height, 0, format, type, nullptr);
    const GLint filter = inside == GL_RGBA8 || inside == GL_R16F ? GL_LINEAR : GL_NEAREST;
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    return t;
  };
  color_ = format_ == GL_RGBA8 ? texture(GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE)
                               : texture(format_, GL_RED, GL_FLOAT);
  depth_ = texture(GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT);
  glGenFramebuffers(1, &frame_);
  glBindFramebuffer(GL_FRAMEBUFFER, frame_);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color_, 0);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth_, 0);
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    fail("cannot draw into a texture", "its framebuffer is incomplete");
}

void Target::bind() const {
  glBindFramebuffer(GL_FRAMEBUFFER, frame_);
  glViewport(0, 0, width_, height_);
}

}  // namespace freshet::gl
