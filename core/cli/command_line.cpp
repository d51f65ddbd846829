#include "osculate/cli/command_line.h"

#include <string>
#include <vector>

#include "osculate/cli/commands.h"

namespace osculate::cli {

namespace {

constexpr const char* kAbout =
    "The geometric continuity G0 to G8 of the curves of CAD models: by how much it fails, and "
    "curves "
    "that have it. Reads STEP, IGES and BREP. Edges are numbered from 1 as FreeCAD numbers them "
    "(Edge1, Edge2, ...). Lengths are mm, angles degrees.";

constexpr const char* kExamples = R"(Examples:
  osculate audit part.step
      all joins of a model: how many of each order, and the ten worst
  osculate analyze part.step --edges 12 13
      everything about the join of two edges
  osculate audit *.step --json report.json --pairs tangent --fail-below G2
      fails a build where curves that should flow into each other are below G2
  osculate blend part.step --edges 12 15 --order 3 -o blend.step
      a curve between two edges that meets both with G3

Exit status: 0 fine, 1 a join is below --fail-below, 2 bad use or a file that cannot be read.)";

constexpr const char* kAnalyzeExamples = R"(Examples:
  osculate analyze part.step --edges 12 13
      the nearest ends of the two edges
  osculate analyze part.step --edges 12 13 --ends end start --order 3 --json
      these ends, up to G3, as JSON (schema osculate.join/1)
  osculate analyze part.step --edges 7
      the joins within one edge: its inner knots, and where it closes
  osculate analyze part.step --edges 7 7 --fail-below G2
      the closing join of a closed edge; status 1 if it is below G2)";

constexpr const char* kAuditExamples = R"(Examples:
  osculate audit part.step
      a summary with the ten worst joins
  osculate audit parts/*.step --csv joins.csv --jobs 4
      every join of many files, four files at once
  osculate audit part.step --json - | jq '.rows[] | select(.order < 2)'
      the joins below G2
  osculate audit part.step --pairs tangent --fail-below G2 || echo not smooth
      corners are left out: pairs whose tangents turn by more than 15 degrees
  find . -name '*.stp' | osculate audit --files-from - --time-limit 60 --json report.json
      a file that takes longer than a minute or makes the reader crash is reported; the rest goes on)";

constexpr const char* kBlendExamples = R"(Examples:
  osculate blend part.step --edges 12 15 --order 3 -o blend.step
      G3 at both ends, between the nearest ends
  osculate blend part.step --edges 12 15 --order 2 4 --ends end start -o blend.brep
      G2 at edge 12 and G4 at edge 15
  osculate blend part.igs --edges 3 4 --order 2 --beta-first 0.9 -o blend.igs --json
      beta_1 at edge 3 is given, the rest is chosen; poles and reports as JSON)";

constexpr const char* kMergeExamples = R"(Examples:
  osculate merge part-*.json --json all.json --csv all.csv
      one report of many, as from a cluster
  osculate merge old.json retried.json --latest --json all.json
      files in both reports as in the later one
  osculate merge part-*.json --fail-below G2 --quiet
      the verdict alone)";

/// CLI11's own say it with the largest number there is, 309 digits.
const CLI::Validator kPositive(
    [](std::string& text) {
      double value = 0.0;
      return CLI::detail::lexical_cast(text, value) && value > 0.0
                 ? std::string()
                 : "must be greater than 0, got " + text;
    },
    "POSITIVE");
const CLI::Validator kNotNegative(
    [](std::string& text) {
      double value = 0.0;
      return CLI::detail::lexical_cast(text, value) && value >= 0.0
                 ? std::string()
                 : "must not be below 0, got " + text;
    },
    "NONNEGATIVE");

void addAnalysis(CLI::App& app, AnalysisChoice& choice) {
  app.add_option("--order", choice.order, "The highest order of contact analysed, 0 to 8")
      ->check(CLI::Range(0, kMaxOrder))
      ->capture_default_str();
  std::vector<std::string> presets;
  for (const TolerancePreset& preset : tolerancePresets())
    presets.emplace_back(preset.name);
  app.add_option("--tolerances", choice.preset, "A preset of tolerances")
      ->check(CLI::IsMember(presets))
      ->capture_default_str();
  const auto own = [&](const char* name, std::optional<double>& value, const char* what) {
    app.add_option(name, value, what)->check(kPositive)->group("Own tolerances");
  };
  own("--gap-mm", choice.gapMm, "Largest gap that still is G0, mm");
  own("--angle-deg", choice.angleDegrees, "Largest angle that still is G1, degrees");
  own("--curvature", choice.curvature, "Largest relative difference of curvature vectors: G2");
  own("--third", choice.third, "The same of third derivatives by arc length: G3");
  own("--fourth", choice.fourth, "The same of higher ones: G4 and above");
}

void addTimeLimit(CLI::App& app, double& seconds, const char* what) {
  app.add_option("--time-limit", seconds, what)->check(kPositive)->type_name("SECONDS");
}

void addFailBelow(CLI::App& app, std::string& order) {
  app.add_option("--fail-below", order, "Exit status 1 where a join is below this order")
      ->type_name("G2");
}

void addEnds(CLI::App& app, std::vector<std::string>& ends) {
  app.add_option("--ends", ends, "Which ends meet, start or end of each edge; else the nearest")
      ->expected(2)
      ->check(CLI::IsMember({"start", "end"}));
}

/// Where results go, for audit and merge.
template <class Choice>
void addResults(CLI::App& app, Choice& choice) {
  app.add_option("--csv", choice.csv, "Write a row for each join; - is standard output")
      ->type_name("OUT");
  app.add_option("--json", choice.json, "Write the report (schema osculate.audit/1); - as above")
      ->type_name("OUT");
  app.add_option("--worst", choice.worst,
                 "How many of the worst joins are printed for a file: 10, or 3 of each of several")
      ->check(kNotNegative)
      ->type_name("N");
  addFailBelow(app, choice.failBelow);
  app.add_flag("--strict", choice.strict,
               "A file of which parts cannot be read or edges not analysed fails: status 2");
  app.add_flag("-q,--quiet", choice.quiet, "Print no text but errors");
}

CLI::App* addCommand(CLI::App& parser, CommandLine& line, const char* name, const char* about,
                     const char* examples, std::function<int()> run) {
  CLI::App* app = parser.add_subcommand(name, about);
  app->footer(examples);
  app->final_callback([&line, run = std::move(run)] { line.run = run; });
  return app;
}

void addAnalyze(CLI::App& parser, CommandLine& line) {
  AnalyzeChoice& choice = line.analyze;
  CLI::App* app = addCommand(parser, line, "analyze", "The join of two edges, or those within one",
                             kAnalyzeExamples, [&choice] { return analyze(choice); });
  app->add_option("file", choice.file, "A STEP, IGES or BREP file")->required();
  app->add_option("--edges", choice.edges, "The numbers of two edges, or of one")
      ->expected(1, 2)
      ->required()
      ->type_name("N [M]");
  addEnds(*app, choice.ends);
  addAnalysis(*app, choice.analysis);
  app->add_flag("--json", choice.json, "JSON instead of the table");
  addFailBelow(*app, choice.failBelow);
  addTimeLimit(*app, choice.timeLimit, "Give up after so long");
}

void addAudit(CLI::App& parser, CommandLine& line) {
  AuditChoice& choice = line.audit;
  CLI::App* app = addCommand(parser, line, "audit", "All joins of models, worst first",
                             kAuditExamples, [&choice] { return audit(choice); });
  app->add_option("files", choice.files, "STEP, IGES and BREP files");
  app->add_option("--files-from", choice.filesFrom,
                  "More files, a path a line in this file; - is standard input")
      ->type_name("LIST");
  addAnalysis(*app, choice.analysis);
  app->add_option("--pairs", choice.pairs,
                  "Which edges at a vertex are a join: all pairs; wire: those that follow each "
                  "other in a wire; tangent: all pairs but corners")
      ->check(CLI::IsMember({"all", "wire", "tangent"}))
      ->capture_default_str();
  app->add_option("--corner-deg", choice.cornerDegrees,
                  "For tangent: what turns by more, 15 if not given, is a corner; a gap counts at "
                  "any angle")
      ->check(CLI::Range(0.0, 180.0));
  app->add_option("--touch-mm", choice.touchMm,
                  "How far ends of edges in no wire (wireframe) may be apart to be a join; 0: such "
                  "edges too join at shared vertices only")
      ->check(kNotNegative)
      ->capture_default_str();
  addResults(*app, choice);
  app->add_option("--jobs", choice.jobs, "Files at once; else as many as there are processors")
      ->check(kPositive)
      ->type_name("N");
  addTimeLimit(*app, choice.timeLimit, "Give up a file after so long");
}

void addBlend(CLI::App& parser, CommandLine& line) {
  BlendChoice& choice = line.blend;
  CLI::App* app = addCommand(parser, line, "blend", "A curve between two edges, smooth at both",
                             kBlendExamples, [&choice] { return blend(choice); });
  app->add_option("file", choice.file, "A STEP, IGES or BREP file")->required();
  app->add_option("--edges", choice.edges, "The numbers of the two edges")
      ->expected(2)
      ->required()
      ->type_name("N M");
  app->add_option("--order", choice.order, "Order of contact, at both edges or at each, 0 to 8")
      ->expected(1, 2)
      ->check(CLI::Range(0, kMaxOrder))
      ->capture_default_str()
      ->type_name("K [K]");
  app->add_option("-o,--output", choice.output,
                  "Where the curve goes: .step, .stp, .iges, .igs, .brep or .brp")
      ->required()
      ->type_name("OUT");
  addEnds(*app, choice.ends);
  app->add_option("--degree", choice.degree, "Of the new curve, up to 25; else the least")
      ->check(CLI::Range(1, kMaxDegree));
  app->add_option("--fairness", choice.fairness,
                  "What the numbers that are not given are chosen by")
      ->check(CLI::IsMember({"mvc", "bending", "none"}))
      ->capture_default_str();
  app->add_flag("--symmetric", choice.symmetric, "Chosen numbers are equal at both ends");
  app->add_option("--beta-first", choice.betaFirst, "beta_1, beta_2, ... at the first edge");
  app->add_option("--beta-second", choice.betaSecond, "The same at the second edge");
  app->add_flag("--json", choice.json, "Print poles, numbers and reports as JSON");
  addTimeLimit(*app, choice.timeLimit, "Give up after so long");
}

void addMerge(CLI::App& parser, CommandLine& line) {
  MergeChoice& choice = line.merge;
  CLI::App* app = addCommand(parser, line, "merge", "One report from many that audit --json wrote",
                             kMergeExamples, [&choice] { return merge(choice); });
  app->add_option("reports", choice.reports, "Reports, all made with the same options")->required();
  addResults(*app, choice);
  app->add_flag("--latest", choice.latest, "Of a file in several reports the last one counts");
}

/// Newer versions of CLI11 (2.5, here of Debian sid) would join the lines of the examples.
template <class Formatter>
void keepLines(Formatter& formatter) {
  if constexpr (requires { formatter.enable_footer_formatting(false); })
    formatter.enable_footer_formatting(false);
}

/// The help in the form that CLI11 2.1 gives it.
class HelpFormatter : public CLI::Formatter {
 public:
  HelpFormatter() {
    column_width(28);
    keepLines(*this);
  }

  /// Newer versions leave out the word where a program has a name.
  std::string make_usage(const CLI::App* app, std::string name) const override {
    std::string usage = CLI::Formatter::make_usage(app, std::move(name));
    const std::string word = get_label("Usage") + ": ";
    if (usage.find(word) == std::string::npos) usage.insert(usage.find_first_not_of('\n'), word);
    return usage;
  }
};

}  // namespace

std::unique_ptr<CLI::App> makeParser(CommandLine& line) {
  auto parser = std::make_unique<CLI::App>(kAbout, "osculate");
  parser->set_version_flag("--version", "osculate " OSCULATE_VERSION);
  parser->require_subcommand(1);
  parser->footer(kExamples);
  parser->formatter(std::make_shared<HelpFormatter>());
  addAnalyze(*parser, line);
  addAudit(*parser, line);
  addBlend(*parser, line);
  addMerge(*parser, line);
  return parser;
}

}  // namespace osculate::cli
