// SPDX-License-Identifier: MIT
/// Without pugixml.
#include "freshet/error.h"
#include "import/xml_tree.h"

namespace freshet {

bool reads_xml() { return false; }

XmlNode parse_xml(const std::string&, const std::string& file) {
  throw Error(Error::Kind::scene, file,
              "this program was built without pugixml, which reads XML; install libpugixml-dev and "
              "zlib1g-dev, and build it again");
}

}  // namespace freshet
