#pragma once

#include <QElapsedTimer>
#include <QWidget>
#include <array>
#include <vector>

class QwtPlot;

namespace insonate::train {

/// Plots of the forces on probe and needle, and of the rates at which their devices report states, over the last
/// seconds.
class HandPlots final : public QWidget {
 public:
  static constexpr double kLast_s = 10;

  explicit HandPlots(QWidget* parent = nullptr);

  /// Adds a point at the present time: for probe and needle, the force in N and the number of states per second from
  /// the device; below 0 if no device is assigned.
  void add(const std::array<double, 2>& force_N, const std::array<double, 2>& rate_Hz);
  std::size_t points() const { return times_s_.size(); }

 private:
  class Trace;
  struct Shown {
    QwtPlot* plot = nullptr;
    std::array<Trace*, 2> traces{};
    std::array<std::vector<double>, 2> values;
  };
  Shown make(const char* object, const QString& title, double usual);
  void show(Shown& shown, double usual);

  QElapsedTimer clock_;
  std::vector<double> times_s_;
  Shown force_, rate_;
};

}  // namespace insonate::train
