#include "draw/svg.h"

#include <gtest/gtest.h>

#include <set>

#include "io/samples.h"

namespace alphamst::draw {
namespace {

namespace samples = io::samples;

std::size_t count(const std::string &text, const std::string &part) {
    std::size_t n = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++n;
    return n;
}

TEST(Svg, FindsSingularities) {
    EXPECT_EQ(picture(samples::cube()).singular3.size(), 8u);
    const io::Arrays grid = samples::grid(5, 2);
    const Picture regular = picture(grid);
    EXPECT_TRUE(regular.singular3.empty() && regular.singular5.empty() && regular.singular_other.empty());
    // n kites around vertex 0.
    for (int n : {2, 3, 5, 6}) {
        io::Arrays star;
        star.points.resize(static_cast<std::size_t>(2 * n + 1) * 3);
        for (int i = 0; i < n; ++i)
            star.faces.insert(star.faces.end(), {0, 1 + 2 * i, 2 + 2 * i, 1 + (2 * i + 2) % (2 * n)});
        const Picture found = picture(star);
        const std::vector<std::int32_t> centre{0};
        EXPECT_EQ(found.singular3 == centre, n == 3);
        EXPECT_EQ(found.singular5 == centre, n == 5);
        EXPECT_EQ(found.singular_other == centre, n == 2 || n == 6);
        EXPECT_EQ(found.singular3.size() + found.singular5.size() + found.singular_other.size(), 1u);
    }
}

TEST(Svg, DrawsTheMesh) {
    const samples::Folder folder;
    io::Arrays mesh;
    mesh.dim = 2;
    mesh.points = {0, 0, 0, 2, 0, 0, 2, 1, 0, 0, 1, 0};
    mesh.faces = {0, 1, 2, 3};
    Picture drawn{&mesh, {{0, 1, 2, 3}}, {}, {1}, {}, {2, 3}, {}};
    write_svg(folder / "m.svg", drawn);
    const std::string text = samples::contents(folder / "m.svg");
    // y points up: vertex 0 is at the bottom left, 5000 units below the top.
    EXPECT_NE(text.find("d=\"m0 5000l10000 0 0-5000-10000 0z\""), std::string::npos) << text;
    EXPECT_EQ(count(text, "<path"), 2u);
    EXPECT_EQ(count(text, "<circle"), 3u + 3u); // vertices and legend
    EXPECT_NE(text.find("valence 3: 1<"), std::string::npos);
    EXPECT_NE(text.find("valence 5: 0<"), std::string::npos);
    EXPECT_NE(text.find("other: 2<"), std::string::npos);
    EXPECT_NE(text.find("4 vertices, 1 faces"), std::string::npos);
    EXPECT_NE(text.find("viewBox=\"-250 -250 10500 6000\""), std::string::npos);
    // White paper under everything, of the size of the picture.
    const std::size_t paper =
        text.find("<rect x=\"-250\" y=\"-250\" width=\"10500\" height=\"6000\" fill=\"#fff\"/>");
    EXPECT_LT(paper, text.find("<path"));
}

TEST(Svg, DrawsLinesBetweenEdgesInTheColourOfTheirNumber) {
    const samples::Folder folder;
    io::Arrays mesh;
    mesh.dim = 2;
    mesh.points = {0, 0, 0, 1, 0, 0, 2, 0, 0, 0, 1, 0, 1, 1, 0, 2, 1, 0};
    mesh.faces = {0, 1, 4, 3, 1, 2, 5, 4};
    Picture drawn = picture(mesh);
    write_svg(folder / "a.svg", drawn);
    const std::size_t without = count(samples::contents(folder / "a.svg"), "<path");
    drawn.lines = {{{0, 3}, {1, 4}, 7}, {{1, 4}, {2, 5}, 7}, {{0, 1}, {3, 4}, -1}};
    write_svg(folder / "a.svg", drawn);
    const std::string text = samples::contents(folder / "a.svg");
    EXPECT_EQ(count(text, "<path"), without + 2);
    EXPECT_EQ(count(text, "stroke-linecap"), 2u);
    // From the left side at half height to the middle edge, and on from there.
    EXPECT_NE(text.find("d=\"m0 2500l5000 0m0 0l5000 0\""), std::string::npos) << text;
}

TEST(Svg, ColoursFacesByTheirErrors) {
    const samples::Folder folder;
    const io::Arrays flat = samples::grid(3, 2), curved = samples::cube();
    for (const io::Arrays *mesh : {&flat, &curved}) {
        Picture drawn = picture(*mesh);
        drawn.errors.assign(mesh->faces.size() / 4, -2);
        write_svg(folder / "small.svg", drawn);
        drawn.errors.assign(mesh->faces.size() / 4, 2);
        write_svg(folder / "large.svg", drawn);
        drawn.errors[0] = 0;
        write_svg(folder / "both.svg", drawn);
        const std::string small = samples::contents(folder / "small.svg");
        EXPECT_NE(small, samples::contents(folder / "large.svg"));
        EXPECT_EQ(count(small, "<rect"), 1u + 5u); // paper and legend
        EXPECT_NE(small.find("area / wanted area"), std::string::npos);
        if (mesh == &curved)
            continue; // which has shades of them
        EXPECT_EQ(count(small, "<path fill=\"#2166ac\""), 1u);
        const std::string both = samples::contents(folder / "both.svg");
        EXPECT_EQ(count(both, "<path fill=\"#b2182b\""), 1u);
        EXPECT_EQ(count(both, "<path fill=\"#f7f7f7\""), 1u);
        EXPECT_EQ(count(both, "<path fill=\"none\" stroke=\"#888\""), 1u); // the edges, on top
    }
}

TEST(Svg, DrawsAnyMesh) {
    const samples::Folder folder;
    io::Arrays huge = samples::cube();
    for (double &x : huge.points)
        x *= 1e308;
    io::Arrays point;
    point.points = {1, 2, 3, 1, 2, 3, 1, 2, 3, 1, 2, 3};
    point.faces = {0, 1, 2, 3};
    for (const io::Arrays &mesh : {io::Arrays(), huge, point, samples::grid(3, 3)}) {
        write_svg(folder / "a.svg", picture(mesh));
        write_svg(folder / "b.svg", picture(mesh));
        const std::string text = samples::contents(folder / "a.svg");
        EXPECT_EQ(text, samples::contents(folder / "b.svg"));
        EXPECT_EQ(text.find("nan"), std::string::npos);
        EXPECT_EQ(text.substr(text.size() - 7), "</svg>\n");
    }
    write_svg(folder / "cube.svg", picture(huge)); // the same picture as of the unit cube
    write_svg(folder / "unit.svg", picture(samples::cube()));
    EXPECT_EQ(count(samples::contents(folder / "cube.svg"), "z"),
              count(samples::contents(folder / "unit.svg"), "z"));
}

// Fill colours of the faces, in the order of the file.
std::vector<std::string> tones(const std::string &text) {
    const std::string part = "<path fill=\"#";
    std::vector<std::string> found;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        found.push_back(text.substr(at + part.size(), 6));
    return found;
}

std::size_t faces(const std::string &text) { return count(text, "zm") + count(text, "z\"/>"); }

// What is drawn in that colour.
std::string path(const std::string &text, const std::string &stroke) {
    const std::size_t from = text.find(" d=\"", text.find("stroke=\"" + stroke + "\"")) + 4;
    return text.substr(from, text.find('"', from) - from);
}

TEST(Svg, DrawsAPlaneMeshAlikeInTwoAndThreeDimensions) {
    const samples::Folder folder;
    io::Arrays mesh = samples::grid(4, 2);
    write_svg(folder / "2.svg", picture(mesh));
    mesh.dim = 3;
    write_svg(folder / "3.svg", picture(mesh));
    const std::string text = samples::contents(folder / "2.svg");
    EXPECT_EQ(text, samples::contents(folder / "3.svg"));
    EXPECT_NE(text.find("<path fill=\"#f2f0e6\" stroke=\"#888\""), std::string::npos); // one colour for all
    EXPECT_EQ(faces(text), 16u);
}

TEST(Svg, ShowsThreeSidesOfACubeInThreeTones) {
    const samples::Folder folder;
    write_svg(folder / "cube.svg", picture(samples::cube()));
    const std::string text = samples::contents(folder / "cube.svg");
    EXPECT_EQ(count(text, "z\"/>"), 3u) << text;
    const std::vector<std::string> found = tones(text);
    ASSERT_EQ(found.size(), 3u);
    EXPECT_NE(found[0], found[1]);
    EXPECT_NE(found[1], found[2]);
    EXPECT_NE(found[0], found[2]);
    EXPECT_EQ(count(text, "<circle"), 7u + 3u); // not the corner behind; legend
    EXPECT_NE(text.find("valence 3: 8<"), std::string::npos);
}

TEST(Svg, ShowsTheHalfOfASphereThatFacesTheEye) {
    const samples::Folder folder;
    const io::Arrays sphere = samples::sphere(12);
    io::Arrays turned_over = sphere;
    for (std::size_t f = 0; f < turned_over.faces.size(); f += 4)
        std::swap(turned_over.faces[f + 1], turned_over.faces[f + 3]);
    write_svg(folder / "a.svg", picture(sphere));
    write_svg(folder / "b.svg", picture(sphere));
    write_svg(folder / "c.svg", picture(turned_over));
    const std::string text = samples::contents(folder / "a.svg");
    const std::size_t n = sphere.faces.size() / 4, drawn = faces(text);
    EXPECT_GT(drawn, 45 * n / 100);
    EXPECT_LT(drawn, 55 * n / 100); // those half turned away, too
    const std::vector<std::string> found = tones(text);
    EXPECT_GT(std::set(found.begin(), found.end()).size(), 20u);
    EXPECT_EQ(text, samples::contents(folder / "b.svg"));
    EXPECT_EQ(faces(samples::contents(folder / "c.svg")), drawn); // normals inwards
    EXPECT_LT(text.size(), 80 * n);
}

TEST(Svg, LeavesOutLinesAndOutlinesThatAreHidden) {
    const samples::Folder folder;
    const io::Arrays cube = samples::cube();
    Picture drawn = picture(cube);
    // Around each side, and over it.
    for (std::size_t f = 0; f < cube.faces.size(); f += 4) {
        const std::int32_t *c = &cube.faces[f];
        drawn.outlines.push_back({c[0], c[1], c[2], c[3]});
        drawn.lines.push_back({{c[0], c[1]}, {c[2], c[3]}, 0});
    }
    write_svg(folder / "cube.svg", drawn);
    const std::string text = samples::contents(folder / "cube.svg");
    EXPECT_EQ(count(path(text, "#1a7a3c"), "l"), 2u * 9u); // an edge is of two sides
    EXPECT_EQ(count(path(text, "#332288"), "l"), 3u);
    EXPECT_EQ(count(path(text, "#1a7a3c"), "z"), 0u);
}

} // namespace
} // namespace alphamst::draw
