// Reads VTK's XML format of unstructured grids (Kitware's file format pages). Expat reads the elements and
// tells where their text is; it is stopped where numbers follow that are no text.
#include <expat.h>

#include <algorithm>
#include <array>
#include <exception>
#include <limits>
#include <memory>
#include <new>
#include <optional>
#include <type_traits>

#include "io/formats.h"
#include "io/number.h"
#include "io/scanner.h"
#include "io/vtk_cells.h"
#include "io/vtu_values.h"

namespace alphamst::io {
namespace {

using vtu::Array;

std::optional<vtk::Type> find_type(std::string_view word) {
    struct Named {
        std::string_view name;
        vtk::Type type;
    };
    using vtk::Kind;
    static constexpr std::array<Named, 10> types{{{"Int8", {Kind::whole, 1}},
                                                  {"UInt8", {Kind::natural, 1}},
                                                  {"Int16", {Kind::whole, 2}},
                                                  {"UInt16", {Kind::natural, 2}},
                                                  {"Int32", {Kind::whole, 4}},
                                                  {"UInt32", {Kind::natural, 4}},
                                                  {"Int64", {Kind::whole, 8}},
                                                  {"UInt64", {Kind::natural, 8}},
                                                  {"Float32", {Kind::real, 4}},
                                                  {"Float64", {Kind::real, 8}}}};
    const auto *const found = std::ranges::find(types, word, &Named::name);
    return found == types.end() ? std::nullopt : std::optional(found->type);
}

// What the elements say.
struct Elements {
    vtu::Encoding encoding;
    std::int64_t n_points = 0, n_cells = 0;
    bool piece = false;
    std::vector<Array> points, cells, of_points, of_cells, of_all;
    std::optional<std::size_t> appended; // the byte behind the _ of the numbers that are no text
    bool appended_base64 = false;
    std::string unread; // names of arrays of other types
};

class Parser {
public:
    explicit Parser(std::string_view bytes) : bytes_(bytes), parser_(XML_ParserCreate(nullptr)) {
        if (!parser_)
            throw std::bad_alloc();
        XML_SetUserData(parser_.get(), this);
        XML_SetElementHandler(parser_.get(), &Parser::start_element, &Parser::end_element);
        XML_SetStartDoctypeDeclHandler(parser_.get(), &Parser::document_type);
    }

    Elements parse() {
        constexpr std::size_t step = 1 << 20; // lengths of expat are 32 bits wide
        for (std::size_t from = 0; from < bytes_.size() || from == 0; from += step) {
            const std::string_view part = bytes_.substr(from, step);
            const bool last = from + step >= bytes_.size();
            const XML_Status status =
                XML_Parse(parser_.get(), part.data(), static_cast<int>(part.size()), last ? 1 : 0);
            if (thrown_)
                std::rethrow_exception(thrown_);
            if (elements_.appended)
                break;
            if (status != XML_STATUS_OK && XML_GetErrorCode(parser_.get()) == XML_ERROR_NO_MEMORY)
                throw std::bad_alloc();
            if (status != XML_STATUS_OK)
                fail(Fault::format, XML_ErrorString(XML_GetErrorCode(parser_.get())));
        }
        place_appended();
        return std::move(elements_);
    }

private:
    struct Free {
        void operator()(XML_Parser parser) const { XML_ParserFree(parser); }
    };

    [[noreturn]] void fail(Fault fault, const std::string &text) const {
        throw Failure(fault, "line " + std::to_string(XML_GetCurrentLineNumber(parser_.get())) + ": " + text);
    }

    // Nothing may be thrown through expat.
    template <class Handle> void guarded(const Handle &handle) noexcept {
        if (thrown_)
            return;
        try {
            handle();
        } catch (...) {
            thrown_ = std::current_exception();
            XML_StopParser(parser_.get(), XML_FALSE);
        }
    }
    static void XMLCALL start_element(void *self, const XML_Char *name, const XML_Char **attributes) {
        auto &parser = *static_cast<Parser *>(self);
        parser.guarded([&] { parser.start(name, attributes); });
    }
    static void XMLCALL end_element(void *self, const XML_Char *name) {
        auto &parser = *static_cast<Parser *>(self);
        parser.guarded([&] { parser.end(name); });
    }
    static void XMLCALL document_type(void *self, const XML_Char *, const XML_Char *, const XML_Char *, int) {
        auto &parser = *static_cast<Parser *>(self);
        parser.guarded([&] { parser.fail(Fault::format, "a file of VTK has no document type"); });
    }

    std::size_t here() const { return static_cast<std::size_t>(XML_GetCurrentByteIndex(parser_.get())); }
    std::size_t behind() const {
        return here() + static_cast<std::size_t>(XML_GetCurrentByteCount(parser_.get()));
    }

    struct Attributes {
        const XML_Char **list;
        std::string_view operator[](std::string_view name) const {
            for (const XML_Char **a = list; *a != nullptr; a += 2)
                if (name == a[0])
                    return a[1];
            return "";
        }
    };

    std::int64_t number(const Attributes &attributes, std::string_view name, std::int64_t otherwise) const {
        const std::string_view word = attributes[name];
        std::int64_t value = otherwise;
        if (!word.empty() && io::parse(word, value) != Parsed::number)
            fail(Fault::format, "found " + quoted(word) + " in place of a whole number");
        if (value < 0 && !word.empty())
            fail(Fault::format, std::string(name) + " cannot be " + std::to_string(value));
        if (value > std::numeric_limits<std::int32_t>::max() && name != "offset")
            fail(Fault::unsupported,
                 std::string(name) + " is " + std::to_string(value) + ", more than 32-bit numbers can name");
        return value;
    }

    void start(std::string_view name, const XML_Char **list) {
        const Attributes attributes{list};
        if (array_) { // with what VTK knows of the numbers, behind them
            array_->end = array_->end == 0 ? here() : array_->end;
            ++inside_;
        } else if (!open_)
            start_file(name, attributes);
        else if (name == "Piece")
            start_piece(attributes);
        else if (name == "DataArray" || name == "Array")
            start_array(attributes);
        else if (name == "AppendedData")
            start_appended(attributes);
        else if (arrays_of(name) != nullptr)
            section_ = arrays_of(name);
    }

    std::vector<Array> *arrays_of(std::string_view section) {
        return section == "Points"      ? &elements_.points
               : section == "Cells"     ? &elements_.cells
               : section == "PointData" ? &elements_.of_points
               : section == "CellData"  ? &elements_.of_cells
               : section == "FieldData" ? &elements_.of_all
                                        : nullptr;
    }

    void start_file(std::string_view name, const Attributes &attributes) {
        open_ = true;
        if (name != "VTKFile")
            fail(Fault::format, "found " + quoted(name) + " in place of VTKFile");
        if (const std::string_view type = attributes["type"]; type != "UnstructuredGrid")
            fail(Fault::unsupported, "a file of type " + quoted(type) +
                                         " is not read, only one UnstructuredGrid; save the mesh as that");
        elements_.encoding.big_endian = attributes["byte_order"] == "BigEndian";
        elements_.encoding.long_lengths = attributes["header_type"] == "UInt64";
        const std::string_view compressor = attributes["compressor"];
        elements_.encoding.zlib = compressor == "vtkZLibDataCompressor";
        if (!compressor.empty() && !elements_.encoding.zlib)
            fail(Fault::unsupported,
                 "data compressed by " + quoted(compressor) + " are not read; take zlib, or none");
    }

    void start_piece(const Attributes &attributes) {
        if (elements_.piece)
            fail(Fault::unsupported,
                 "the file has several pieces; merge them into one, as the filter Clean to "
                 "Grid of ParaView does");
        elements_.piece = true;
        elements_.n_points = number(attributes, "NumberOfPoints", 0);
        elements_.n_cells = number(attributes, "NumberOfCells", 0);
    }

    void start_array(const Attributes &attributes) {
        if (section_ == nullptr)
            return;
        const std::optional<vtk::Type> type = find_type(attributes["type"]);
        if (!type) { // words and bits
            elements_.unread += (elements_.unread.empty() ? "" : ", ") + quoted(attributes["Name"]);
            return;
        }
        Array array;
        array.name = attributes["Name"];
        array.type = *type;
        array.components = std::max<std::int64_t>(number(attributes, "NumberOfComponents", 1), 1);
        array.tuples = number(attributes, "NumberOfTuples", -1);
        array.begin = behind();
        const std::string_view format = attributes["format"];
        if (format == "appended") {
            array.place = Array::Place::raw;
            array.begin = static_cast<std::size_t>(number(attributes, "offset", 0));
        } else if (format == "binary") {
            array.place = Array::Place::base64;
        } else if (format != "ascii") {
            fail(Fault::format, "found " + quoted(format) + " in place of ascii, binary or appended");
        }
        array_ = std::move(array);
    }

    void start_appended(const Attributes &attributes) {
        elements_.appended_base64 = attributes["encoding"] == "base64";
        if (!elements_.appended_base64 && attributes["encoding"] != "raw")
            fail(Fault::format, "found " + quoted(attributes["encoding"]) + " in place of raw or base64");
        const std::size_t mark = bytes_.find_first_not_of(" \t\r\n", behind());
        if (mark == std::string_view::npos || bytes_[mark] != '_')
            fail(Fault::format, "AppendedData do not begin with _");
        elements_.appended = mark + 1;
        XML_StopParser(parser_.get(), XML_FALSE);
    }

    void end(std::string_view name) {
        if (inside_ > 0) {
            --inside_;
        } else if (array_) {
            if (array_->place != Array::Place::raw)
                array_->end = std::max(array_->end == 0 ? here() : array_->end, array_->begin);
            section_->push_back(*std::exchange(array_, std::nullopt));
        } else if (arrays_of(name) != nullptr) {
            section_ = nullptr;
        }
    }

    void place_appended() {
        for (std::vector<Array> *section : {&elements_.points, &elements_.cells, &elements_.of_points,
                                            &elements_.of_cells, &elements_.of_all})
            for (Array &array : *section) {
                if (array.place != Array::Place::raw)
                    continue;
                const std::size_t first = elements_.appended.value_or(bytes_.size());
                if (array.begin > bytes_.size() - first)
                    fail(Fault::format,
                         io::quoted(array.name) + " begins behind the end of the file; it was cut off");
                array.begin += first;
                array.end = bytes_.size();
                if (elements_.appended_base64)
                    array.place = Array::Place::base64;
            }
    }

    std::string_view bytes_;
    std::unique_ptr<std::remove_pointer_t<XML_Parser>, Free> parser_;
    std::exception_ptr thrown_;
    Elements elements_;
    bool open_ = false;
    std::vector<Array> *section_ = nullptr;
    std::optional<Array> array_;
    int inside_ = 0; // elements that have begun in it
};

class Reader {
public:
    explicit Reader(std::string_view bytes) : bytes_(bytes), elements_(Parser(bytes).parse()) {}

    Arrays read() {
        if (!elements_.piece)
            scan_.malformed("the file has no Piece");
        if (elements_.points.empty())
            scan_.malformed("the file has no Points");
        Arrays mesh;
        move_to(elements_.points.front());
        read_points(mesh);
        vtk::DataSet data;
        const Array &connectivity = array_of_cells("connectivity");
        data.cells.connectivity = integers(connectivity, -1);
        data.cells.offsets = integers(array_of_cells("offsets"), elements_.n_cells);
        data.cells.offsets.insert(data.cells.offsets.begin(), 0);
        data.types = integers(array_of_cells("types"), elements_.n_cells);
        move_to(connectivity);
        vtk::require_ascending(scan_, data.cells);
        data.of_points = data_of(elements_.of_points, elements_.n_points);
        data.of_cells = data_of(elements_.of_cells, elements_.n_cells);
        data.of_all = data_of(elements_.of_all, -1);
        if (!elements_.unread.empty())
            mesh.remarks.push_back("data that are no numbers are left out: " + elements_.unread);
        vtk::add_data_set(scan_, std::move(data), mesh);
        return finished(std::move(mesh));
    }

private:
    void read_points(Arrays &mesh) const {
        const std::vector<double> points =
            vtu::reals(bytes_, elements_.points.front(), elements_.encoding, 3 * elements_.n_points);
        mesh.points.reserve(points.size());
        for (std::size_t i = 0; i < points.size(); i += 3)
            add_vertex(scan_, mesh, points[i], points[i + 1], points[i + 2]);
    }

    // What is wrong with numbers has the place of the first of them: compressed ones have none of their own.
    void move_to(const Array &array) {
        scan_ = Scanner(bytes_);
        scan_.take(array.begin);
        scan_.take(0);
    }

    const Array &array_of_cells(std::string_view name) const {
        for (const Array &array : elements_.cells)
            if (same_word(array.name, name))
                return array;
        scan_.malformed("the file has no " + std::string(name) + " of cells");
    }

    std::vector<std::int64_t> integers(const Array &array, std::int64_t wanted) const {
        return vtu::integers(bytes_, array, elements_.encoding, wanted);
    }

    std::vector<vtk::Data> data_of(const std::vector<Array> &arrays, std::int64_t n) const {
        std::vector<vtk::Data> all;
        for (const Array &array : arrays) {
            const std::int64_t tuples = n >= 0 ? n : array.tuples;
            all.push_back(
                {array.name, array.components, array.type.kind != vtk::Kind::real,
                 vtu::reals(bytes_, array, elements_.encoding, tuples < 0 ? -1 : tuples * array.components)});
        }
        return all;
    }

    std::string_view bytes_;
    Elements elements_;
    Scanner scan_{bytes_};
};

} // namespace

Arrays parse_vtu(std::string_view bytes) { return Reader(bytes).read(); }

} // namespace alphamst::io
