// Writes VTK's XML format of unstructured grids, version 1.0: numbers as they are in memory, little-endian
// and not compressed, behind the text, so that any reader finds them and none rounds them.
#include <array>
#include <span>

#include "io/bytes.h"
#include "io/formats.h"
#include "io/markers.h"
#include "io/vtk_cells.h"

namespace alphamst::io {
namespace {

// The length of the character of UTF-8 that the text begins with, 0 if there is none.
std::size_t character(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const std::size_t n = byte(0) < 0x80   ? 1
                          : byte(0) < 0xc2 ? 0
                          : byte(0) < 0xe0 ? 2
                          : byte(0) < 0xf0 ? 3
                          : byte(0) < 0xf5 ? 4
                                           : 0;
    if (n == 0 || n > text.size())
        return 0;
    char32_t code = n == 1 ? byte(0) : byte(0) & (0x7fu >> n);
    for (std::size_t i = 1; i < n; ++i) {
        if ((byte(i) & 0xc0) != 0x80)
            return 0;
        code = code << 6 | (byte(i) & 0x3fu);
    }
    constexpr std::array<char32_t, 5> least{0, 0, 0x80, 0x800, 0x10000};
    const bool in_xml =
        (code < 0xd800 || code > 0xdfff) && code != 0xfffe && code != 0xffff && code <= 0x10ffff;
    return code >= least[n] && in_xml ? n : 0;
}

// XML has no place for bytes that are no characters.
std::string escaped(std::string_view name) {
    std::string known = clean_name(name);
    for (std::size_t i = 0, n = 0; i < known.size(); i += n) {
        n = character(std::string_view(known).substr(i));
        if (n == 0)
            known[i] = '_';
        n = n == 0 ? 1 : n;
    }
    std::string text;
    for (const char c : known) // no quotes are left
        text += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
    return text;
}

// The text comes from its end to its beginning, so that the numbers of the first element are the last ones:
// meshio 5.0 moves numbers and looks for elements by their old places among the new ones,
// and takes the first that it finds.
class Writer {
public:
    std::string write(const Arrays &mesh) {
        const vtk::DataSet data = vtk::data_set_of(mesh);
        before("</Cells>\n</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_");
        add<std::uint8_t>("UInt8", "types", 1, data.types);
        add<std::int64_t>("Int64", "offsets", 1, std::span(data.cells.offsets).subspan(1));
        add<std::int64_t>("Int64", "connectivity", 1, data.cells.connectivity);
        before("</Points>\n<Cells>\n");
        add<double>("Float64", "Points", 3, mesh.points);
        before("<Points>\n");
        add_all("CellData", data.of_cells, false);
        add_all("PointData", data.of_points, false);
        before("<Piece NumberOfPoints=\"" + std::to_string(mesh.points.size() / 3) + "\" NumberOfCells=\"" +
               std::to_string(data.types.size()) + "\">\n");
        add_all("FieldData", data.of_all, true);
        before("<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
               "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<UnstructuredGrid>\n");
        return text_ + behind_ + "\n</AppendedData>\n</VTKFile>\n";
    }

private:
    void before(const std::string &text) { text_.insert(0, text); }

    void add_all(const std::string &section, const std::vector<vtk::Data> &all, bool of_any_length) {
        if (all.empty())
            return;
        before("</" + section + ">\n");
        for (auto data = all.rbegin(); data != all.rend(); ++data) {
            const std::string tuples =
                of_any_length ? " NumberOfTuples=\"" + std::to_string(data->values.size()) + "\"" : "";
            if (data->whole)
                add<std::int32_t>("Int32", data->name, data->components, data->values, tuples);
            else
                add<double>("Float64", data->name, data->components, data->values, tuples);
        }
        before("<" + section + ">\n");
    }

    template <class Number, class Values>
    void add(const char *type, std::string_view name, std::int64_t components, const Values &values,
             const std::string &tuples = "") {
        before(std::string("<DataArray type=\"") + type + "\" Name=\"" + escaped(name) +
               "\" NumberOfComponents=\"" + std::to_string(components) + "\"" + tuples +
               " format=\"appended\" offset=\"" + std::to_string(behind_.size()) + "\"/>\n");
        append_little(behind_, std::uint64_t{values.size() * sizeof(Number)});
        for (const auto value : values)
            append_little(behind_, static_cast<Number>(value));
    }

    std::string text_, behind_;
};

} // namespace

std::string print_vtu(const Arrays &mesh) { return Writer().write(mesh); }

} // namespace alphamst::io
