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

/// The rules that a scenario's grammar stands for: those of the task for the words `ppa`, `nominal` and `published` (the
/// authors' code of 2022), otherwise the text itself.
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
        _ => return Cow::Borrowed(grammar),
    })
}
