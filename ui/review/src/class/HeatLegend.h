#pragma once

#include <QWidget>

namespace insonate::review {

/// Legend of the heat map's colors.
class HeatLegend final : public QWidget {
 public:
  explicit HeatLegend(QWidget* parent = nullptr);

 protected:
  void paintEvent(QPaintEvent* event) override;
};

}  // namespace insonate::review
