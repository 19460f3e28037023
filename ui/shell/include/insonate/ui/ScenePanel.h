#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/views/LabelColours.h>
#include <insonate/views/SceneView.h>

#include <QTimer>
#include <QWidget>
#include <map>
#include <memory>

class QCheckBox;
class QSettings;

namespace insonate::ui {

class ClippingControls;
class EyeControls;
class HistogramEditor;
class StructureList;
class ValueSlider;

/// Controls of a three-dimensional view: skin transparency, structures, the CT with its transfer function, a clipping
/// plane, stereo and the head-coupled view. During changes the view is drawn coarser until the hand rests. The panel
/// is narrow and long: put it into a QScrollArea. For the window's thread.
///
/// The scene informs the panel of surfaces and looks (SceneView::setStructuresChanged is the panel's from now on), so
/// a scene has one panel, which also shows the changes of others.
class ScenePanel : public QWidget {
  Q_OBJECT

 public:
  /// Controls by which structures are shown and hidden, colored and made transparent, the skin included.
  enum class Structures {
    Here,
    Elsewhere,  ///< by whoever owns the scene; the panel leaves their looks alone
  };
  explicit ScenePanel(std::shared_ptr<views::SceneView> scene, QWidget* parent = nullptr,
                      Structures structures = Structures::Here);
  ~ScenePanel() override;

  /// Sets the case whose histogram is shown; the owner of the scene sets the scene's own case. Null for none.
  /// Structures changed here look as the case's author chose, until the next case; the user's choices for others stay,
  /// but another patient starts with skin and without the CT volume. An author's colors do not replace safe ones.
  void setCase(std::shared_ptr<const PatientCase> patient);

  HistogramEditor& histogram() { return *histogram_; }

  views::ColourScheme colourScheme() const { return scheme_; }
  /// Applies the scheme's colors to all structures, or with the default scheme those of the case.
  void setColourScheme(views::ColourScheme scheme);
  /// Restores the author's choice, else shows all structures with the colors of the scheme and the default opacities.
  void showUsual();

  /// All but the clipping plane, which belongs to one patient.
  void save(QSettings& settings) const;
  void restore(QSettings& settings);

 Q_SIGNALS:
  /// A structure has another color in the scene: slices may want it, too.
  void coloursChanged();

 protected:
  void showEvent(QShowEvent* event) override;

 private:
  QWidget* buildStructures();
  QWidget* buildCt();
  void refresh();
  void scrollToHistogram();
  /// Coarser from now on until nothing has changed for a moment.
  void live();
  struct Look {
    views::Colour colour;
    double opacity = 1;
    bool visible = true;
  };
  Look look(std::uint8_t label) const;
  void setLook(std::uint8_t label, const Look& look);
  views::Colour caseColour(std::uint8_t label) const;
  void takeLooks();
  void showAnother();

  std::shared_ptr<views::SceneView> scene_;
  ValueSlider* skin_ = nullptr;
  StructureList* structures_ = nullptr;
  QCheckBox* safeColours_ = nullptr;
  QCheckBox* ct_ = nullptr;
  HistogramEditor* histogram_ = nullptr;
  ClippingControls* clipping_ = nullptr;
  EyeControls* eyes_ = nullptr;
  std::shared_ptr<const PatientCase> patient_;
  std::shared_ptr<const PatientCase> last_;  ///< the same, or the one before there was none
  std::map<std::uint8_t, Look> own_;         ///< the user's, of structures that look as the case says
  views::ColourScheme scheme_ = views::ColourScheme::Usual;
  bool structuresHere_ = true, refreshing_ = false, refreshDue_ = false;
  QTimer rest_;
};

}  // namespace insonate::ui
