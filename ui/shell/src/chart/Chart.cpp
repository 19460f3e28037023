#include "ChartItems.h"

#include <insonate/ui/Theme.h>

#include <qwt_plot.h>
#include <qwt_plot_canvas.h>

#include <QAction>
#include <QContextMenuEvent>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QPainter>
#include <QVBoxLayout>

namespace insonate::ui {

Chart::Chart(QWidget* parent) : QWidget(parent), plot_(new QwtPlot(this)), save_(new QAction(this)) {
  auto* canvas = new QwtPlotCanvas(plot_);
  canvas->setFrameStyle(QFrame::NoFrame);
  canvas->setPalette(toQColor(views::theme::kGround));
  plot_->setCanvas(canvas);
  plot_->setFocusPolicy(Qt::NoFocus);
  canvas->setFocusPolicy(Qt::NoFocus);
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(kSmallGap, kSmallGap, kSmallGap, kSmallGap);
  box->addWidget(plot_);
  setFocusPolicy(Qt::StrongFocus);
  setMinimumSize(240, 150);
  save_->setText(tr("Save plot ..."));
  save_->setShortcut(QKeySequence(QStringLiteral("Ctrl+Shift+E")));
  save_->setShortcutContext(Qt::WidgetWithChildrenShortcut);
  addAction(save_);
  connect(save_, &QAction::triggered, this, [this] { choose(); });
  show({});
}

Chart::~Chart() = default;

void Chart::show(ChartContents picture) {
  picture_ = std::move(picture);
  setAccessibleName(picture_.title.isEmpty() ? tr("Plot") : picture_.title);
  setAccessibleDescription(picture_.words);
  setToolTip(tr("%1\nA right click or Ctrl+Shift+E saves the plot").arg(accessibleName().toHtmlEscaped()));
  fillPlot(*plot_, picture_, screenInk());
  plot_->setVisible(!picture_.isEmpty());
  save_->setEnabled(!picture_.isEmpty());
  update();
}

void Chart::choose() {
  QString name;
  for (const QChar letter : picture_.title) name += letter.isLetterOrNumber() ? letter.toLower() : QChar('-');
  const QString file = QFileDialog::getSaveFileName(
      this, tr("Save the plot"), QDir::home().filePath((name.isEmpty() ? tr("plot") : name) + QStringLiteral(".png")),
      tr("Image (*.png);;Drawing (*.svg);;Page (*.pdf)"));
  if (!file.isEmpty()) save(file);
}

void Chart::save(const QString& file) {
  const auto saved = saveChart(file, picture_);
  if (!saved) return Q_EMIT failed(QString::fromStdString(saved.error().message), {});
  Q_EMIT written(tr("Plot saved as %1.").arg(QFileInfo(file).fileName()), QFileInfo(file).absolutePath());
}

void Chart::contextMenuEvent(QContextMenuEvent* event) {
  QMenu menu(this);
  menu.addAction(save_);
  menu.exec(event->globalPos());
}

void Chart::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), toQColor(views::theme::kGround));
  painter.setPen(toQColor(hasFocus() ? views::theme::kAccent : views::theme::kLine));
  painter.drawRect(rect().adjusted(0, 0, -1, -1));
  if (!picture_.isEmpty()) return;
  painter.setPen(toQColor(views::theme::kQuiet));
  const QRect inside = rect().adjusted(kLargeGap, kLargeGap, -kLargeGap, -kLargeGap);
  painter.drawText(
      inside, Qt::AlignCenter | Qt::TextWordWrap,
      picture_.title.isEmpty() ? picture_.words : picture_.title + QStringLiteral("\n\n") + picture_.words);
}

void Chart::focusInEvent(QFocusEvent* event) {
  QWidget::focusInEvent(event);
  update();
}

void Chart::focusOutEvent(QFocusEvent* event) {
  QWidget::focusOutEvent(event);
  update();
}

}  // namespace insonate::ui
