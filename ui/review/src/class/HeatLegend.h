#pragma once

#include <QWidget>

namespace insonate::review {

/// What the heat map's colours mean.
class HeatLegend final : public QWidget {
 public:
  explicit HeatLegend(QWidget* parent = nullptr);

 protected:
  void paintEvent(QPaintEvent* event) override;
};

}  // namespace insonate::review
