#pragma once

#include <QProxyStyle>

namespace insonate::ui {

/// Style that shows text in labels, message boxes and tooltips as plain text, since it may contain names of people and
/// titles of cases. HTML in the text is neither interpreted nor loaded, unless a label is explicitly set to rich text.
/// Overlong words do not widen the window.
class PlainStyle final : public QProxyStyle {
  Q_OBJECT

 public:
  using QProxyStyle::polish;
  using QProxyStyle::QProxyStyle;
  void polish(QWidget* widget) override;
};

}  // namespace insonate::ui
