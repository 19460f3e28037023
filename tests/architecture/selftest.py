"""Every rule must notice a tree that breaks it, name the place, and leave a good tree alone."""

import tempfile
import unittest
from pathlib import Path

import rules
import words

ALL = rules.RULES + words.RULES

GOOD = {
    "CMakeLists.txt": "",
    "modules/core/README.md": "core",
    "modules/core/include/insonate/core/A.h": "#pragma once\n#include <vector>\n",
    "modules/ultrasound/README.md": "ultrasound",
    "modules/ultrasound/include/insonate/ultrasound/B.h":
        "#pragma once\n#include <insonate/core/A.h>\n#include <nlohmann/json_fwd.hpp>\n"
        "void f(const nlohmann::json& settings);\n",
    "modules/ultrasound/src/B.cpp": 
        "#include <insonate/embedded/probes.h>\n#include <opencv2/core.hpp>\n#include <nlohmann/json.hpp>\n",
    "modules/cases/README.md": "cases",
    "modules/cases/src/C.cpp": "#include <insonate/tissue/Labels.h>\n#include <itkImage.h>\n",
    "modules/surface/README.md": "surface",
    "modules/surface/src/D.cpp":
        "#include <insonate/tissue/Labels.h>\n#include <vtkFlyingEdges3D.h>\n#include <vtkWindowedSincPolyDataFilter.h>\n",
    "tests/unit/surface/DTest.cpp": "",
    "ui/views/src/E.cpp": "#include <insonate/cases/C.h>\n#include <vtkRenderer.h>\n",
    "ui/shell/src/F.cpp": "#include <insonate/views/E.h>\n#include <QWidget>\n",
    "ui/prepare/src/tools/T.cpp": '#include "../labels/L.h"\n#include "../layout/M.h"\n#include "U.h"\n',
    "ui/prepare/src/W.cpp": '#include "tools/T.h"\n',
    "ui/prepare/src/measure/V.cpp": '#include "../tools/T.h"\n',
    "ui/train/src/G.cpp": "#include <insonate/ui/F.h>\n#include <insonate/views/E.h>\n",
    "tests/unit/core/ATest.cpp": "",
    "tests/unit/ultrasound/BTest.cpp": "",
    "tests/unit/cases/CTest.cpp": "",
    # Words: continued comments, code, and texts that are not shown may say what they like.
    "ui/shell/src/H.cpp": "// The probe's pose,\n// of which more below.\nint of = 1;  ///< of the probe\n"
        'auto* b = new QPushButton(tr("Save case"));\nf("picture", tr("Image"));\n',
    "modules/core/include/insonate/core/B.h": "#pragma once\n/// Saves `picture` as \"colour\", see savePicture().\nint x;\n",
    "resources/help/h.md": "The image. `picture`\n",
    "README.md": "An image, [here](picture.png)\n\n```\npicture\n```\n",
}

# rule, file, its text, what the sentence must say
BAD = [
    ("check_floors", "modules/core/src/X.cpp", "#include <insonate/image/Volume.h>\n", "above it"),
    ("check_floors", "modules/ultrasound/src/X.cpp", "\n# include \"insonate/segmentation/AutoLabel.h\"\n", "X.cpp:2"),
    ("check_floors", "modules/tissue/src/X.cpp", "#include <insonate/image/Volume.h>\n", "own floor"),
    ("check_floors", "modules/mystery/src/X.cpp", "", "no floor"),
    ("check_floors", "modules/cases/src/X.cpp", "#include <insonate/mystery/X.h>\n", "without a floor"),
    ("check_private_headers", "app/insonate-cli/X.cpp", '#include "../../modules/core/src/P.h"\n', "public headers"),
    ("check_public_headers", "modules/cases/include/insonate/cases/X.h", "#include <itkImage.h>\n", "ITK"),
    ("check_public_headers", "modules/cases/include/insonate/cases/X.h", "#include <gdcmReader.h>\n", "GDCM"),
    ("check_public_headers", "modules/core/include/insonate/core/X.h", "#include <opencv2/core.hpp>\n", "OpenCV"),
    ("check_public_headers", "modules/core/include/insonate/core/X.h", "#include <nlohmann/json.hpp>\n", "json_fwd"),
    ("check_public_headers", "modules/core/include/insonate/core/X.h", "#include <hidapi/hidapi.h>\n", "hidapi"),
    ("check_public_headers", "modules/core/include/insonate/core/X.h", "#include <insonate/embedded/x.h>\n", "by the build"),
    ("check_public_headers", "modules/core/include/insonate/core/X.h", "#include <QtSql/QSqlQuery>\n", "SQL"),
    ("check_public_headers", "modules/core/include/insonate/core/X.h", "void f(cv::Mat picture);\n", "library's type"),
    ("check_floors", "modules/surface/src/X.cpp", "#include <insonate/segmentation/AutoLabel.h>\n", "own floor"),
    ("check_public_headers", "modules/surface/include/insonate/surface/X.h", "#include <vtkPolyData.h>\n", "VTK"),
    ("check_public_headers", "modules/surface/include/insonate/surface/X.h", "class vtkPolyData;\n", "library's type"),
    ("check_floors", "ui/views/src/X.cpp", "#include <insonate/ui/Workspace.h>\n", "above it"),
    ("check_floors", "ui/train/src/X.cpp", "#include <insonate/review/X.h>\n", "own floor"),
    ("check_public_headers", "modules/gpu/include/insonate/gpu/X.h", "#include <epoxy/gl.h>\n", "OpenGL"),
    ("check_toolkits", "modules/ultrasound/src/X.cpp", "#include <GL/gl.h>\n", "belongs in gpu"),
    ("check_toolkits", "ui/views/src/X.cpp", "#include <QWidget>\n", "views know VTK only"),
    ("check_toolkits", "modules/ultrasound/src/X.cpp", "#include <QWidget>\n", "without Qt"),
    ("check_toolkits", "modules/curriculum/src/X.cpp", "#include <QtWidgets/QLabel>\n", "without Qt"),
    ("check_toolkits", "modules/surface/src/X.cpp", "#include <vtkRenderWindow.h>\n", "ui/views"),
    ("check_toolkits", "modules/surface/src/X.cpp", "#include <vtkPolyDataMapper.h>\n", "ui/views"),
    ("check_toolkits", "modules/ultrasound/src/X.cpp", "#include <vtkImageData.h>\n", "surface"),
    ("check_sql", "app/insonate-cli/X.cpp", "#include <sqlite3.h>\n", "curriculum"),
    ("check_sql", "modules/simulator/src/X.cpp", 'run("SELECT name FROM learner");\n', "SQL statement"),
    ("check_top_level", "utils/X.cpp", "", "not a room"),
    ("check_modules_complete", "modules/image/src/X.cpp", "", "no README"),
    ("check_modules_complete", "modules/image/src/X.cpp", "", "no tests"),
    ("check_length", "modules/core/src/X.cpp", "\n" * (rules.MAX_LINES + 1), "801 lines"),
    ("check_architecture_page", "ARCHITECTURE.md", "It has `NoSuchType`.\n", "names NoSuchType"),
    ("check_architecture_page", "ARCHITECTURE.md", "See `core/Gone.h`.\n", "no public header"),
    ("check_architecture_page", "ARCHITECTURE.md", "```mermaid\ncases --> core\n```\n", "module ultrasound is missing"),
    ("check_functions", "modules/core/src/X.cpp", "void work() {\n" + "  f();\n" * (rules.MAX_FUNCTION_LINES + 1) + "}\n", "work has 61"),
    ("check_basenames", "modules/core/src/deep/A.h", "#pragma once\n", "has the name of"),
    ("check_features", "ui/train/src/needle/X.cpp", '#include "../probe/P.h"\n', "another feature"),
    ("check_features", "ui/train/src/model/X.cpp", '#include "../probe/P.h"\n', "model includes ../probe/P.h"),
    ("check_features", "ui/prepare/src/guide/X.cpp", '#include "../tools/T.h"\n', "guide includes ../tools/T.h"),
    ("check_features", "ui/prepare/src/guide/X.cpp", '#include "tools/T.h"\n', "guide includes tools/T.h"),
    ("check_features", "ui/prepare/src/labels/X.cpp", '#include "../recipe/R.h"\n', "labels includes ../recipe/R.h"),
    ("check_comments", "modules/core/src/X.cpp", "/// Of the probe, in mm.\nint x;\n", 'begins with "Of"'),
    ("check_comments", "ui/shell/src/X.cpp", "int x;  ///< What it holds\n", 'X.cpp:1: a comment begins with "What"'),
    ("check_comments", "shaders/x.glsl", "// Where gates lie.\n", 'begins with "Where"'),
    ("check_header_comments", "modules/core/include/insonate/core/X.h", "#pragma once\n/// As in `A.h`.\nint x;\n",
     'X.h:2: the comment begins with "As"'),
    ("check_header_comments", "modules/core/include/insonate/core/X.h", "#pragma once\nint x;  ///< Without unit\n", '"Without"'),
    ("check_header_comments", "modules/core/include/insonate/core/X.h", "#pragma once\n/// Saves a\n/// picture.\nint x;\n",
     'X.h:2: "picture"'),
    ("check_header_comments", "modules/core/include/insonate/core/X.h", "#pragma once\nint x;  ///< x in the probe's frame\n",
     "probe frame"),
    ("check_window_texts", "ui/shell/src/X.cpp", 'f(tr("The picture"\n     " is lost"));\n', '"picture" in a window text'),
    ("check_window_texts", "ui/shell/src/X.cpp", '\n\nf(tr("Take back"));\n', "X.cpp:3"),
    ("check_window_texts", "ui/shell/src/X.cpp", 'f(tr("Colour of the vein"));\n', "US spelling"),
    ("check_window_texts", "ui/shell/src/X.cpp", 'f(tr("At most"));\n', "say: minimum or maximum"),
    ("check_buttons", "ui/shell/src/X.cpp", 'auto* b = new QPushButton(tr("Close it now"));\n', "is a sentence"),
    ("check_buttons", "ui/shell/src/X.cpp", 'menu->addAction(tr("Closes."));\n', "is a sentence"),
    ("check_pages", "resources/help/x.md", "# X\n\nWhoever signs in\n", "x.md:3"),
    ("check_pages", "README.md", "A picture of the neck\n", "say: image"),
    ("check_pages", "ARCHITECTURE.md", "The thread comes behind the others\n", "say: lower priority"),
    ("check_pages", "CONTRIBUTING.md", "The needle is in plane\n", "say: in-plane"),
    ("check_pages", "modules/core/README.md", "The probe presses\n", "say: compress"),
    ("check_pages", "ui/shell/README.md", "A dark vessel\n", "say: anechoic"),
    ("check_finished", "modules/core/src/X.cpp", "// TO" + "DO: later\n", "unfinished"),
    ("check_pragma_once", "modules/core/src/X.h", "int x;\n", "pragma once"),
]


def build(root, files):
    for name, text in files.items():
        file = Path(root) / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")


class Rules(unittest.TestCase):
    def test_a_good_tree_passes(self):
        with tempfile.TemporaryDirectory() as root:
            build(root, GOOD)
            self.assertEqual(rules.violations(root), [])

    def test_each_bad_file_is_found_by_its_rule(self):
        for rule, name, text, says in BAD:
            with self.subTest(rule=rule, file=name, text=text), tempfile.TemporaryDirectory() as root:
                build(root, {**GOOD, name: text})
                found = [sentence for check in ALL if check.__name__ == rule for sentence in check(Path(root))]
                self.assertTrue(any(says in sentence for sentence in found), found)

    def test_every_rule_is_tried(self):
        self.assertEqual({rule.__name__ for rule in ALL}, {rule for rule, *_ in BAD})


if __name__ == "__main__":
    unittest.main()
