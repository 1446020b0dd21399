// SPDX-License-Identifier: MIT
#include <algorithm>

#include "view/stage.h"

namespace freshet::view {
namespace {

class Writer {
 public:
  template <class T> void operator()(const T& value) { all.push_back(float(value)); }
  void operator()(const Point& p) {
    for (const double x : {p.x, p.y, p.z}) (*this)(x);
  }
  void operator()(const Tint& t) {
    for (const float x : {t.r, t.g, t.b, t.a}) (*this)(x);
  }
  void operator()(const std::vector<float>& values) {
    (*this)(values.size());
    all.insert(all.end(), values.begin(), values.end());
  }
  std::vector<float> all;
};

class Reader {
 public:
  explicit Reader(std::span<const float> numbers) : left_(numbers) {}
  template <class T> void operator()(T& value) {
    value = T(left_.front());
    left_ = left_.subspan(1);
  }
  void operator()(Point& p) {
    for (double* x : {&p.x, &p.y, &p.z}) (*this)(*x);
  }
  void operator()(Tint& t) {
    for (float* x : {&t.r, &t.g, &t.b, &t.a}) (*this)(*x);
  }
  void operator()(std::vector<float>& values) {
    std::size_t size = 0;
    (*this)(size);
    values.assign(left_.begin(), left_.begin() + std::ptrdiff_t(size));
    left_ = left_.subspan(size);
  }

 private:
  std::span<const float> left_;
};

template <class Visit, class S> void visit_stage(Visit& visit, S& stage) {
  visit(stage.flat);
  visit(stage.spacing);
  visit(stage.glow);
  visit(stage.low);
  visit(stage.high);
  visit(stage.background);
  auto& start = stage.start;
  visit(start.flat);
  visit(start.target);
  for (auto* number : {&start.distance, &start.yaw, &start.pitch, &start.field_of_view,
                       &start.width, &start.height})
    visit(*number);
}

template <class Visit, class P> void visit_part(Visit& visit, P& part) {
  visit(part.triangles);
  visit(part.lines);
  visit(part.points);
  visit(part.fill);
  visit(part.edge);
  visit(part.body);
  visit(part.start);
}

}  // namespace

std::vector<float> packed(const Stage& stage) {
  Writer write;
  visit_stage(write, stage);
  write(stage.parts.size());
  for (const Part& part : stage.parts) {
    write(int(part.kind));
    visit_part(write, part);
  }
  return std::move(write.all);
}

Stage unpacked(std::span<const float> numbers) {
  Reader read(numbers);
  Stage stage;
  visit_stage(read, stage);
  std::size_t parts = 0;
  read(parts);
  for (; parts > 0; --parts) {
    Part part;
    int kind = 0;
    read(kind);
    part.kind = Part::Kind(kind);
    visit_part(read, part);
    stage.parts.push_back(std::move(part));
  }
  return stage;
}

}  // namespace freshet::view
