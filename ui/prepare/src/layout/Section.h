#pragma once

#include <QString>
#include <QWidget>

class QLabel;
class QToolButton;

namespace insonate::prepare {

/// A section of a column. The user can collapse the section under its heading.
class Section : public QWidget {
 public:
  /// `key` identifies the section in the settings.
  Section(const QString& key, const QString& title, QWidget* content, QWidget* parent = nullptr);

  const QString& key() const { return key_; }
  bool isOpen() const;
  void setOpen(bool open);
  /// Sets a short text beside the heading.
  void setRemark(const QString& remark);

 private:
  QString key_, title_;
  QWidget* content_;
  QToolButton* heading_;
  QLabel* remark_;
};

}  // namespace insonate::prepare
