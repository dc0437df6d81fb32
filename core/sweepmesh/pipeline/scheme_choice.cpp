#include "sweepmesh/pipeline/scheme_choice.h"

#include <algorithm>

#include "sweepmesh/pipeline/cap_match.h"
#include "sweepmesh/pipeline/layout.h"

namespace sweepmesh {
namespace {

class Chooser {
 public:
  Chooser(const std::vector<Assessment>& verdicts, const std::vector<Contact>& contacts,
          bool quad_caps)
      : verdicts_(verdicts), contacts_(contacts), quad_caps_(quad_caps) {}

  std::vector<SchemeChoice> run() const {
    const SchemeChoice best = best_choice();
    std::vector<std::pair<double, SchemeChoice>> others;
    for_each_change(best, [&](const SchemeChoice& c) { others.emplace_back(cost(c), c); });
    std::sort(others.begin(), others.end());
    std::vector<SchemeChoice> out = {best};
    constexpr std::size_t max_tries = 8;
    for (const auto& [cost, choice] : others)
      if (out.size() < max_tries) out.push_back(choice);
    return out;
  }

 private:
  /// Changes one solid's scheme after the other as long as that helps.
  SchemeChoice best_choice() const {
    SchemeChoice best(verdicts_.size(), 0);
    double least = cost(best);
    for (bool is_better = true; is_better;) {
      is_better = false;
      SchemeChoice next = best;
      for_each_change(best, [&](const SchemeChoice& c) {
        const double its = cost(c);
        if (its >= least) return;
        least = its;
        next = c;
        is_better = true;
      });
      best = next;
    }
    return best;
  }

  template <class Visit>
  void for_each_change(const SchemeChoice& choice, const Visit& visit) const {
    for (std::size_t s = 0; s < choice.size(); ++s)
      for (const std::size_t other : tries(verdicts_[s].schemes.size())) {
        SchemeChoice changed = choice;
        changed[s] = other;
        if (other != choice[s]) visit(changed);
      }
  }

  double cost(const SchemeChoice& choice) const {
    double sum = 0.0;
    for (std::size_t s = 0; s < choice.size(); ++s)
      if (choice[s] > 0) sum += cost_of_scheme(verdicts_[s].schemes, choice[s]);
    for (const Contact& c : contacts_) sum += cost_of_contact(choice, c);
    return sum;
  }

  /// Schemes as good as the best, as those along a brick's other axes, are hardly worse.
  static double cost_of_scheme(const std::vector<Scheme>& schemes, std::size_t s) {
    constexpr double alike = 1e-6, slight = 0.1;
    const bool is_as_good = schemes[s].cost <= schemes[0].cost + alike;
    return (is_as_good ? slight : 1.0) * static_cast<double>(s);
  }

  double cost_of_contact(const SchemeChoice& choice, const Contact& c) const {
    const Scheme& a = verdicts_[c.solid].schemes[choice[c.solid]];
    const Scheme& b = verdicts_[c.other].schemes[choice[c.other]];
    const bool a_links = a.face_role[c.face.index] == FaceRole::linking;
    const bool b_links = b.face_role[c.other_face.index] == FaceRole::linking;
    if (a_links && b_links) return 0.0;
    if (!a_links && !b_links) return is_one_to_one(a) || is_one_to_one(b) ? 0.0 : 1.0;
    if (!quad_caps_) return 100.0;
    return is_one_to_one(a_links ? b : a) ? 0.25 : 3.0;
  }

  const std::vector<Assessment>& verdicts_;
  const std::vector<Contact>& contacts_;
  const bool quad_caps_;
};

}  // namespace

std::vector<SchemeChoice> scheme_choices(const std::vector<Assessment>& verdicts,
                                         const std::vector<Contact>& contacts, bool quad_caps) {
  return Chooser(verdicts, contacts, quad_caps).run();
}

}  // namespace sweepmesh
