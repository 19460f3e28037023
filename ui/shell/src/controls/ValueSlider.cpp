#include <insonate/ui/Theme.h>
#include <insonate/ui/ValueSlider.h>

#include <QEvent>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMouseEvent>
#include <QSlider>
#include <QStyle>
#include <QToolTip>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

namespace insonate::ui {
namespace {

constexpr int kPage = 10;
constexpr double kNotch = 120;  // QWheelEvent counts in eighths of a degree
constexpr int kHandle_px = 12;

int stepsOf(const ValueRange& range) {
  return std::max(1, int(std::lround((range.maximum - range.minimum) / range.step)));
}

}  // namespace

/// The slider counts steps; the number itself may be between two.
class ValueSlider::Track final : public QSlider {
 public:
  explicit Track(ValueSlider& owner) : QSlider(Qt::Horizontal), owner_(owner) {
    setFocusPolicy(Qt::StrongFocus);
    setPageStep(kPage);
    connect(this, &QSlider::valueChanged, &owner, [this](int steps) {
      if (!quiet_) owner_.setValue(owner_.range_.minimum + steps * owner_.range_.step);
    });
  }

  void follow(double value) {
    quiet_ = true;
    setRange(0, stepsOf(owner_.range_));
    setValue(int(std::lround((value - owner_.range_.minimum) / owner_.range_.step)));
    quiet_ = false;
  }

 protected:
  void mousePressEvent(QMouseEvent* event) override {
    if (event->button() == Qt::LeftButton) jump(*event);
    QSlider::mousePressEvent(event);
  }
  void mouseDoubleClickEvent(QMouseEvent*) override { owner_.reset(); }
  void wheelEvent(QWheelEvent* event) override {
    rest_ += event->angleDelta().y() / kNotch;
    const double whole = std::trunc(rest_);
    rest_ -= whole;
    owner_.setValue(owner_.value_ + whole * owner_.range_.step);
    event->accept();
  }
  void keyPressEvent(QKeyEvent* event) override {
    const int direction = event->key() == Qt::Key_Right || event->key() == Qt::Key_Up    ? 1
                          : event->key() == Qt::Key_Left || event->key() == Qt::Key_Down ? -1
                                                                                         : 0;
    if (direction == 0) return QSlider::keyPressEvent(event);
    owner_.setValue(owner_.value_ + direction * owner_.range_.step);
  }

 private:
  /// A press on the track moves the handle there.
  void jump(const QMouseEvent& event) {
    setValue(
        QStyle::sliderValueFromPosition(minimum(), maximum(), event.pos().x() - kHandle_px / 2, width() - kHandle_px));
  }

  ValueSlider& owner_;
  double rest_ = 0;
  bool quiet_ = false;
};

ValueSlider::ValueSlider(const QString& name, const QString& unit, const ValueRange& range, const QString& hint,
                         QWidget* parent)
    : QWidget(parent),
      name_(name),
      unit_(unit),
      hint_(hint),
      range_(range),
      value_(range.defaultValue),
      label_(new QLabel(name)),
      number_(new QLineEdit),
      track_(new Track(*this)) {
  setRole(number_, "value");
  number_->setAlignment(Qt::AlignRight);
  number_->setFrame(false);
  label_->installEventFilter(this);
  number_->installEventFilter(this);
  connect(number_, &QLineEdit::editingFinished, this, &ValueSlider::typed);

  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(kGap);
  grid->setVerticalSpacing(2);
  grid->addWidget(label_, 0, 0);
  grid->addWidget(number_, 0, 1);
  grid->addWidget(track_, 1, 0, 1, 2);
  grid->setColumnStretch(0, 1);
  setFocusProxy(track_);
  describe();
  fitNumber();
  showValue();
}

QString ValueSlider::text(double value) const {
  const QString number = QString::number(value, 'f', range_.decimals);
  return unit_.isEmpty() ? number : number + QStringLiteral(" ") + unit_;
}

void ValueSlider::describe() {
  QString tip =
      tr("%1: %2 to %3, default %4.").arg(name_, text(range_.minimum), text(range_.maximum), text(range_.defaultValue));
  if (!hint_.isEmpty()) tip = hint_ + QStringLiteral("\n") + tip;
  setToolTip(tip + tr("\nDouble click restores the default; arrow keys or Ctrl+wheel change the value in steps."));
  for (QWidget* part : {static_cast<QWidget*>(track_), static_cast<QWidget*>(number_)}) {
    part->setAccessibleName(unit_.isEmpty() ? name_ : tr("%1 in %2").arg(name_, unit_));
    part->setAccessibleDescription(hint_);
  }
}

/// For the longest number and its unit, and not wider, since two sliders are beside each other in a narrow column.
void ValueSlider::fitNumber() {
  constexpr int kFrame_px = 16;  // padding and border of the theme, and the text cursor
  number_->ensurePolished();
  const QFontMetrics& font = number_->fontMetrics();
  number_->setFixedWidth(
      std::max(font.horizontalAdvance(text(range_.minimum)), font.horizontalAdvance(text(range_.maximum))) + kFrame_px);
}

void ValueSlider::showValue() {
  track_->follow(value_);
  number_->setText(text(value_));
}

void ValueSlider::setValue(double value) {
  if (!std::isfinite(value)) return;
  const double unitInTheLastPlace = std::pow(10.0, range_.decimals);
  const double kept =
      std::clamp(std::round(value * unitInTheLastPlace) / unitInTheLastPlace, range_.minimum, range_.maximum);
  const bool differs = kept != value_;
  value_ = kept;
  showValue();
  if (differs) Q_EMIT valueChanged(value_);
}

void ValueSlider::setRange(const ValueRange& range) {
  range_ = range;
  describe();
  fitNumber();
  setValue(value_);
}

void ValueSlider::typed() {
  QString written = number_->text();
  if (!unit_.isEmpty()) written.remove(unit_);
  bool isNumber = false;
  const double value = written.trimmed().replace(QLatin1Char(','), QLatin1Char('.')).toDouble(&isNumber);
  isNumber = isNumber && std::isfinite(value);
  if (!isNumber || value < range_.minimum || value > range_.maximum) {
    const QString sentence = isNumber ? tr("%1 must be from %2 to %3; %4 is outside this range.")
                                      : tr("%1 takes a number from %2 to %3; \"%4\" is not a number.");
    QToolTip::showText(number_->mapToGlobal({0, number_->height()}),
                       sentence.arg(name_, text(range_.minimum), text(range_.maximum), number_->text().trimmed()),
                       number_);
  }
  if (isNumber)
    setValue(value);
  else
    showValue();
}

bool ValueSlider::eventFilter(QObject* watched, QEvent* event) {
  if (watched == label_ && event->type() == QEvent::MouseButtonDblClick) {
    reset();
    return true;
  }
  // An applied number has no undo of its own; the window may have one.
  if (watched == number_ && event->type() == QEvent::ShortcutOverride && !number_->isUndoAvailable() &&
      static_cast<QKeyEvent*>(event)->matches(QKeySequence::Undo)) {
    event->ignore();
    return true;
  }
  if (watched == number_ && event->type() == QEvent::KeyPress) {
    const auto* press = static_cast<QKeyEvent*>(event);
    if (press->key() == Qt::Key_Escape) {
      showValue();
      track_->setFocus();
      return true;
    }
    // Ends the input of the number only, since the window's own Enter may write.
    if (press->key() == Qt::Key_Return || press->key() == Qt::Key_Enter) {
      typed();
      number_->selectAll();
      return true;
    }
    if (press->key() == Qt::Key_Up || press->key() == Qt::Key_Down) {
      typed();
      setValue(value_ + (press->key() == Qt::Key_Up ? range_.step : -range_.step));
      return true;
    }
  }
  return QWidget::eventFilter(watched, event);
}

}  // namespace insonate::ui
