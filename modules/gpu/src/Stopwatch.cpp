#include <insonate/gpu/Stopwatch.h>

#include <epoxy/gl.h>

#include <utility>

namespace insonate::gpu {

Result<Stopwatch> Stopwatch::make(const CurrentContext& current, int marks) {
  Stopwatch watch;
  watch.context_ = current.context();
  watch.ids_.resize(marks);
  glGenQueries(marks, watch.ids_.data());
  if (auto ok = current.check(); !ok) return tl::unexpected(ok.error());
  return watch;
}

Stopwatch::Stopwatch(Stopwatch&& other) noexcept {
  *this = std::move(other);
}

Stopwatch& Stopwatch::operator=(Stopwatch&& other) noexcept {
  std::swap(context_, other.context_), std::swap(ids_, other.ids_);
  return *this;
}

Stopwatch::~Stopwatch() {
  if (ids_.empty()) return;
  if (const auto current = context_->use()) glDeleteQueries(int(ids_.size()), ids_.data());
}

void Stopwatch::mark(const CurrentContext&, int mark) const {
  glQueryCounter(ids_[mark], GL_TIMESTAMP);
}

double Stopwatch::between_ms(const CurrentContext&, int from, int to) const {
  GLuint64 start_ns = 0, end_ns = 0;
  glGetQueryObjectui64v(ids_[from], GL_QUERY_RESULT, &start_ns);
  glGetQueryObjectui64v(ids_[to], GL_QUERY_RESULT, &end_ns);
  return end_ns > start_ns ? double(end_ns - start_ns) * 1e-6 : 0;
}

}  // namespace insonate::gpu
