//! The built-in grammars, bound to a task.

use super::params::Task;
use std::borrow::Cow;

/// The PPA grammar of BeTr-GEESE (BNF-II), after the paper's appendix B. The paper elides the alternatives of pc, p, k
/// and action; they are those of the authors' grammar for foraging. The order matters: a codon chooses by number. Actions
/// and objects follow.
const PPA: &str = "\
<S> ::= <root>
<root> ::= <sequence> | <selector>
<sequence> ::= Seq[<ppa>] | Seq[<root> <root>] | Seq[<sequence> <root>]
<selector> ::= Sel[<ppa>] | Sel[<root> <root>] | Sel[<selector> <root>]
<ppa> ::= Sel[<postconditions> <ppasequence>]
<postconditions> ::= <successnode> | <ppa> | Seq[<postcondition>]
<postcondition> ::= <postcondition> Post(<pc>) | Post(<pc>)
<pc> ::= NeighbourObjects <o> | NeighbourObjects <s> | NeighbourObjects <d> | IsCarrying <d> | IsVisitedBefore <s>
<ppasequence> ::= Seq[<preconditions> Act(<action>)] | Seq[<constraints> Act(<action>)]
  | Seq[<preconditions> <constraints> Act(<action>)]
<preconditions> ::= Seq[<precondition>]
<precondition> ::= <precondition> Pre(<p>) | Pre(<p>)
<p> ::= IsDropable <s> | NeighbourObjects <o> | not NeighbourObjects <o> | IsVisitedBefore <s>
  | not IsVisitedBefore <s> | IsCarrying <d> | not IsCarrying <d>
<constraints> ::= Seq[<constraint>]
<constraint> ::= <constraint> Con(<k>) | Con(<k>)
<k> ::= CanMove | IsCarryable <d> | IsDropable <s>
";
/// Its actions.
const PPA_ACTIONS: &str = "\
<action> ::= MoveTowards <s> | Explore | CompositeSingleCarry <d> | CompositeDrop <d> | MoveAway <s>
";

const OBJECTS: &str = "<o> ::= <s> | <d>\n";

/// Foraging's actions in the authors' code of 2022: another order, and two kinds of items, one of which is nowhere.
const FORAGE_2022: &str = "\
<action> ::= MoveTowards <s> | Explore | MoveAway <s> | CompositeSingleCarry <d> | CompositeDrop <d>
";

/// The actions of nest maintenance in the authors' code of 2022: what moves may look ahead or not.
const NEST_2022: &str = "\
<action> ::= <motion> | <nonmotion>
<motion> ::= MoveTowards <s> <t> | Explore <t> | MoveAway <s> <t>
<t> ::= Normal | Avoid
<nonmotion> ::= CompositeSingleCarry <d> | CompositeDrop <d>
";

/// The nominal grammar of GEESE-BT (BNF-I), as in the authors' public grammars; the paper does not print it.
const NOMINAL: &str = "\
<S> ::= <cf>
<cf> ::= <sequence> | <selector>
<sequence> ::= Seq[<execution>] | Seq[<cf> <cf>] | Seq[<sequence> <cf>]
<selector> ::= Sel[<execution>] | Sel[<cf> <cf>] | Sel[<selector> <cf>]
<execution> ::= <conditions> Act(<action>)
<conditions> ::= Cond(<condition>) <conditions> | Cond(<condition>)
<condition> ::= NeighbourObjects | IsDropable <s> | NeighbourObjects <o> | not NeighbourObjects <o>
  | IsVisitedBefore <s> | not IsVisitedBefore <s> | IsCarrying <d> | not IsCarrying <d>
<action> ::= MoveTowards <s> | Explore | CompositeSingleCarry <d> | CompositeDrop <d> | MoveAway <s>
<o> ::= <s> | <d>
";

/// State machines for GEESE. Its grammar is not public: these rules are our reading, with the shape of a rule set that
/// the authors' grammar library ships unused (three states, seven tests and a comparison; the next state; a variable),
/// and with the primitive behaviours and conditions of the trees in place of numbers. What is tested: hub, site (in the
/// nest: boundary) and item sensed, item carried, site known, and two variables; `-` tests nothing.
const MACHINE: &str = "\
<S> ::= <rules>
<rules> ::= <rule> | <rule> <rules> | <rule> <rule> <rules> | <rule> <rule> <rule> <rules>
<rule> ::= From(<state> <state> <state>) If(<hub> <far> <item> <load> <known> <x> <y> equals <bool>) \
  Goto(<often>, <state>) Set(<variable>, <bool>, <seldom>)
<state> ::= Explore | MoveTowards Far | MoveTowards Hub | CompositeSingleCarry Item | CompositeDrop Item
<hub> ::= not NeighbourObjects Hub | NeighbourObjects Hub | -
<far> ::= not NeighbourObjects Far | NeighbourObjects Far | -
<item> ::= not NeighbourObjects Item | NeighbourObjects Item | -
<load> ::= not IsCarrying Item | IsCarrying Item | -
<known> ::= not IsVisitedBefore Far | IsVisitedBefore Far | -
<x> ::= not X | X | -
<y> ::= not Y | Y | -
<variable> ::= X | Y
<bool> ::= true | false
<often> ::= 0.1 | 0.2 | 0.5 | 0.7 | 1
<seldom> ::= 0.001 | 0.005 | 0.01 | 0.025 | 0.05 | 0.075 | 0.1 | 1
";

/// A tree written by hand for both tasks: the baseline that evolution is measured against. Every genome gives it. It
/// senses the source before it asks whether it knows it, so that it learns of it on the way.
const HAND_TREE: &str = "\
<S> ::= Sel[<bring> <take> <go> Explore]
<bring> ::= Seq[IsCarrying Item Sel[<drop> MoveTowards Sink]]
<drop> ::= Seq[NeighbourObjects Sink CompositeDrop Item]
<take> ::= Seq[NeighbourObjects Item CompositeSingleCarry Item]
<go> ::= Seq[not NeighbourObjects Source IsVisitedBefore Source MoveTowards Source]
";

/// The same as a state machine.
const HAND_MACHINE: &str = "\
<S> ::= <drop> <bring> <take> <go> <search>
<drop> ::= From(MoveTowards Sink CompositeSingleCarry Item) If(IsCarrying Item NeighbourObjects Sink equals true) \
  Goto(1, CompositeDrop Item)
<bring> ::= From(CompositeSingleCarry Item) If(IsCarrying Item equals true) Goto(1, MoveTowards Sink)
<take> ::= From(Explore MoveTowards Source CompositeDrop Item CompositeSingleCarry Item) \
  If(NeighbourObjects Item equals true) Goto(1, CompositeSingleCarry Item)
<go> ::= From(Explore CompositeDrop Item CompositeSingleCarry Item) \
  If(not NeighbourObjects Source IsVisitedBefore Source equals true) Goto(1, MoveTowards Source)
<search> ::= From(MoveTowards Source CompositeDrop Item CompositeSingleCarry Item) \
  If(not NeighbourObjects Source IsVisitedBefore Source equals false) Goto(1, Explore)
";

/// The rules that a scenario's grammar stands for: those of the task for the words `ppa`, `nominal`, `published` (the
/// authors' code of 2022), `machine`, `hand-tree` and `hand-machine`, otherwise the text itself.
///
/// The places and items are the task's own; the paper prints Food and Debris for both tasks, and no boundary (our
/// choice).
#[must_use]
pub fn grammar_text(grammar: &str, task: Task) -> Cow<'_, str> {
    let dummy = "<successnode> ::= Post(DummyNode)\n";
    let (places, item, actions) = match task {
        Task::Forage => ("Hub | Sites", "Food", FORAGE_2022),
        Task::Nest => ("Hub | Boundary", "Debris", NEST_2022),
    };
    let bind = |rules: &str, item: &str, last: &str| format!("{rules}<s> ::= {places}\n<d> ::= {item}\n{last}");
    Cow::Owned(match grammar.trim() {
        "ppa" => bind(&format!("{PPA}{PPA_ACTIONS}{OBJECTS}"), item, dummy),
        "nominal" => bind(NOMINAL, item, ""),
        "published" => {
            let items = if task == Task::Forage { "Food | Debris" } else { item };
            bind(&format!("{PPA}{actions}{OBJECTS}"), items, dummy)
        }
        "machine" => return bound(MACHINE, task),
        "hand-tree" => return bound(HAND_TREE, task),
        "hand-machine" => return bound(HAND_MACHINE, task),
        _ => return Cow::Borrowed(grammar),
    })
}

/// Puts the task's own words in the place of Source, Sink, Far (the place that is not the hub) and Item.
fn bound(rules: &str, task: Task) -> Cow<'static, str> {
    let mut text = String::with_capacity(rules.len());
    // All of it is ASCII; every piece but the last ends with what separates words.
    for piece in rules.split_inclusive(|c: char| !c.is_ascii_alphanumeric()) {
        let (word, end) = piece.split_at(piece.len() - 1);
        text.push_str(match (task, word) {
            (Task::Forage, "Source" | "Far") => "Sites",
            (Task::Nest, "Sink" | "Far") => "Boundary",
            (Task::Forage, "Sink") | (Task::Nest, "Source") => "Hub",
            (Task::Forage, "Item") => "Food",
            (Task::Nest, "Item") => "Debris",
            (_, other) => other,
        });
        text.push_str(end);
    }
    Cow::Owned(text)
}
