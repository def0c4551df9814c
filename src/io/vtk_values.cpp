#include "io/vtk_values.h"

#include <algorithm>
#include <array>

namespace alphamst::io::vtk {

std::optional<Type> find_type(std::string_view word) {
    struct Named {
        std::string_view name;
        Type type;
    };
    static constexpr std::array<Named, 17> types{{{"char", {Kind::whole, 1}},
                                                  {"signed_char", {Kind::whole, 1}},
                                                  {"unsigned_char", {Kind::natural, 1}},
                                                  {"short", {Kind::whole, 2}},
                                                  {"unsigned_short", {Kind::natural, 2}},
                                                  {"int", {Kind::whole, 4}},
                                                  {"unsigned_int", {Kind::natural, 4}},
                                                  {"long", {Kind::whole, 8}},
                                                  {"unsigned_long", {Kind::natural, 8}},
                                                  {"vtkidtype", {Kind::whole, 4}}, // VTK writes it as int
                                                  {"vtktypeint32", {Kind::whole, 4}},
                                                  {"vtktypeuint32", {Kind::natural, 4}},
                                                  {"vtktypeint64", {Kind::whole, 8}},
                                                  {"vtktypeuint64", {Kind::natural, 8}},
                                                  {"float", {Kind::real, 4}},
                                                  {"double", {Kind::real, 8}},
                                                  {"bit", {Kind::natural, 0}}}};
    for (const Named &named : types)
        if (same_word(named.name, word))
            return named.type;
    return std::nullopt;
}

Type Values::read_type() {
    const std::string_view word = scan_.word();
    const std::optional<Type> type = find_type(word);
    if (!type)
        scan_.malformed(quoted(word) + " is not a type of VTK");
    return *type;
}

std::size_t Values::least(Type type) const { return binary ? std::max<std::size_t>(type.size, 1) : 2; }

void Values::begin() {
    if (binary)
        scan_.line();
}

double real_of(const char *bytes, Type type, bool big_endian) {
    if (type.kind != Kind::real)
        return static_cast<double>(integer_of(bytes, type, big_endian));
    return type.size == 4 ? static_cast<double>(decode<float>(bytes, big_endian))
                          : decode<double>(bytes, big_endian);
}

std::int64_t integer_of(const char *bytes, Type type, bool big_endian) {
    const bool natural = type.kind == Kind::natural;
    switch (type.size) {
    case 1:
        return natural ? std::int64_t{decode<std::uint8_t>(bytes, true)} : decode<std::int8_t>(bytes, true);
    case 2:
        return natural ? std::int64_t{decode<std::uint16_t>(bytes, big_endian)}
                       : decode<std::int16_t>(bytes, big_endian);
    case 4:
        return natural ? std::int64_t{decode<std::uint32_t>(bytes, big_endian)}
                       : decode<std::int32_t>(bytes, big_endian);
    default:
        return decode<std::int64_t>(bytes, big_endian);
    }
}

double Values::real(Type type) {
    return binary ? real_of(scan_.take(type.size).data(), type, true) : scan_.real();
}

std::int64_t Values::integer(Type type) {
    return binary ? integer_of(scan_.take(type.size).data(), type, true) : scan_.integer();
}

std::vector<double> Values::reals(std::int64_t n, Type type) {
    scan_.expect(n, "values", least(type));
    std::vector<double> numbers(static_cast<std::size_t>(n));
    for (double &x : numbers)
        x = real(type);
    return numbers;
}

std::vector<std::int64_t> Values::integers(std::int64_t n, Type type) {
    if (type.kind == Kind::real || type.size == 0)
        scan_.malformed("cells are not whole numbers");
    begin();
    scan_.expect(n, "numbers", least(type));
    std::vector<std::int64_t> numbers(static_cast<std::size_t>(n));
    for (std::int64_t &i : numbers)
        i = integer(type);
    return numbers;
}

} // namespace alphamst::io::vtk
