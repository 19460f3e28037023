#pragma once

#include <QProxyStyle>

namespace insonate::ui {

/// Names of people and titles of cases stand in labels, message boxes and tooltips. What looks like HTML there is shown
/// as it is, and nothing is fetched for it, unless a label says by itself that it is rich text. A word without an end
/// does not widen the window.
class PlainStyle final : public QProxyStyle {
  Q_OBJECT

 public:
  using QProxyStyle::polish;
  using QProxyStyle::QProxyStyle;
  void polish(QWidget* widget) override;
};

}  // namespace insonate::ui
