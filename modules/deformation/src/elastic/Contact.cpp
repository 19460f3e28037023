#include "elastic/Contact.h"

#include <algorithm>

namespace insonate::elastic {

void Contact::prepare(const Nodes& rest, int columns) {
  columns_ = columns;
  restX_.assign(rest.x.begin(), rest.x.begin() + columns);
  met_.clear();
  length_.assign(columns, 0.0f);
  for (int i = 0; i + 1 < columns; ++i) {
    const float half = (rest.x[i + 1] - rest.x[i]) / 2;
    length_[i] += half;
    length_[i + 1] += half;
  }
}

void Contact::meet(const FaceProfile& face, const Nodes& at) {
  profile_.resize(columns_);
  added_.assign(columns_, 0);
  if (touched_.size() != std::size_t(columns_)) touched_.assign(columns_, 0);
  touching_ = touched_;
  stuckX_.resize(columns_);
  for (int i = 0; i < columns_; ++i) stuckX_[i] = touched_[i] ? restX_[i] : at.x[i];
  const bool again = met_.size() == std::size_t(columns_);
  met_.resize(columns_);
  for (int i = 0; i < columns_; ++i) {
    met_[i] = again ? (met_[i] + at.x[i]) / 2 : at.x[i];
    profile_[i] = face.at(met_[i]);
  }
}

void Contact::remember(float shift_mm, const Nodes& at) {
  for (int i = 0; i < columns_; ++i) touched_[i] = profile_[i].under && profile_[i].z_mm + shift_mm > at.z[i];
}

void Contact::settle() {
  std::fill(touching_.begin(), touching_.end(), 0);
}

void Contact::add(float shift_mm, bool sticking, const Nodes& at, GridMatrix& matrix, std::vector<float>& force) {
  for (int i = 0; i < columns_; ++i) {
    const FaceProfile::Point p = profile_[i];
    const float depth = p.z_mm + shift_mm - at.z[i];
    added_[i] = touches(i, depth);
    if (!added_[i]) {
      stuckX_[i] = at.x[i];
      continue;
    }
    const float k = kStiffness_kPa_mm * length_[i];
    force[2 * i + 1] += k * depth;
    matrix.value[2][i] += k;
    if (sticking) {
      force[2 * i] -= k * (at.x[i] - stuckX_[i]);
      matrix.value[0][i] += k;
    }
  }
}

float Contact::pressing(float shift_mm, const Nodes& at) const {
  double sum = 0;
  for (int i = 0; i < columns_; ++i) {
    const FaceProfile::Point p = profile_[i];
    const float depth = p.z_mm + shift_mm - at.z[i];
    if (touches(i, depth)) sum += double(kStiffness_kPa_mm) * length_[i] * depth;
  }
  return static_cast<float>(sum);
}

float Contact::foreseen(float shift_mm, const Nodes& at) const {
  double sum = 0;
  for (int i = 0; i < columns_; ++i)
    if (added_[i]) sum += double(kStiffness_kPa_mm) * length_[i] * (profile_[i].z_mm + shift_mm - at.z[i]);
  return static_cast<float>(std::max(sum, 0.0));
}

void Contact::pushByShift(float shift_mm, const Nodes& at, std::vector<float>& force) const {
  for (int i = 0; i < columns_; ++i) {
    const FaceProfile::Point p = profile_[i];
    if (!touches(i, p.z_mm + shift_mm - at.z[i])) continue;
    const float k = kStiffness_kPa_mm * length_[i];
    force[2 * i + 1] += k;
  }
}

float Contact::sum(const std::vector<float>& force) const {
  double sum = 0;
  for (int i = 0; i < columns_; ++i) sum += force[2 * i + 1];
  return static_cast<float>(sum);
}

float Contact::product(const std::vector<float>& a, const std::vector<float>& b) const {
  double sum = 0;
  for (int i = 0; i < columns_; ++i) sum += double(a[2 * i + 1]) * b[2 * i + 1];
  return static_cast<float>(sum);
}

float Contact::gap(float shift_mm, const Nodes& at) const {
  float gap = 1000;
  for (int i = 0; i < columns_; ++i)
    if (profile_[i].under) gap = std::min(gap, at.z[i] - profile_[i].z_mm - shift_mm);
  return gap;
}

}  // namespace insonate::elastic
