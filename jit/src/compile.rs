//! Machine code of a tape, by cranelift.
//!
//! Straight-line code in parts of bounded length, since register allocation grows faster than a block does. A
//! value that another part uses, and every sine and cosine, lives in scratch memory; these and inputs are read where
//! they are used; the rest is left to the register allocator. Where the machine multiplies and adds in
//! one instruction, a product that is used once, by a sum, is part of the sum. No `unsafe` here: the product is a
//! [`Code`], which says what calling it rests on.

use crate::native::{Code, Frame, sin_cos};
use crate::program::RESULTS;
use crate::tape::{Input, Step, Tape};
use codegen::expr::{F1, F2};
use cranelift_codegen::ir::condcodes::FloatCC;
use cranelift_codegen::ir::{AbiParam, FuncRef, InstBuilder, MemFlagsData, Type, Value, types};
use cranelift_codegen::isa::{OwnedTargetIsa, TargetIsa};
use cranelift_codegen::settings::{self, Configurable};
use cranelift_frontend::{FunctionBuilder, FunctionBuilderContext};
use cranelift_jit::{JITBuilder, JITModule};
use cranelift_module::{FuncId, Linkage, Module, ModuleError, default_libcall_names};
use rustc_hash::FxHashMap;
use std::fmt;
use std::mem::offset_of;
use std::ops::Range;

/// Steps in one part: up to here compile time is proportional to size, and larger parts run no faster.
const PART: usize = 500;
/// Operations for which a value that was read from memory is kept at hand. Kept for longer it drives others out of
/// the registers; read anew each time it costs an instruction.
const NEAR: usize = 16;

/// Why there is no machine code; the interpreter takes over.
#[derive(Debug)]
pub enum NoCode {
    /// cranelift has no backend for this machine.
    Host(&'static str),
    /// A setting, the code or its memory was refused (some systems forbid memory that is executable).
    Refused(String),
}

impl fmt::Display for NoCode {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Host(why) => write!(f, "no machine code for this machine: {why}"),
            Self::Refused(why) => write!(f, "no machine code: {why}"),
        }
    }
}

impl std::error::Error for NoCode {}

impl From<ModuleError> for NoCode {
    fn from(error: ModuleError) -> Self {
        Self::Refused(error.to_string())
    }
}

/// Compiles a tape.
///
/// # Errors
/// [`NoCode`] where this machine cannot be given code.
pub fn compile(tape: &Tape) -> Result<Code, NoCode> {
    let isa = host()?;
    let plan = Plan::new(tape, PART, multiplies_and_adds(&*isa));
    let mut builder = JITBuilder::with_isa(isa, default_libcall_names());
    Imports::register(&mut builder);
    let mut module = JITModule::new(builder);
    let imports = Imports::declare(&mut module)?;
    let mut signature = module.make_signature();
    signature.params.push(AbiParam::new(module.target_config().pointer_type()));
    let mut context = module.make_context();
    let mut memory = FunctionBuilderContext::new();
    let mut parts = Vec::new();
    for range in plan.bounds.windows(2) {
        let id = module.declare_anonymous_function(&signature)?;
        context.func.signature = signature.clone();
        let b = FunctionBuilder::new(&mut context.func, &mut memory);
        Part::new(tape, &plan, &imports, &mut module, b).build(range[0]..range[1]);
        module.define_function(id, &mut context)?;
        module.clear_context(&mut context);
        parts.push(id);
    }
    module.finalize_definitions()?;
    Ok(Code::new(module, &parts, tape, plan.scratch))
}

/// Instruction set of this machine.
fn host() -> Result<OwnedTargetIsa, NoCode> {
    let mut flags = settings::builder();
    // what cranelift-jit needs, then what measured best: the graph has no common subexpressions left to find, and
    // moving operations around (`speed`) made code of several parts slower by a third
    let needed = [("is_pic", "false"), ("use_colocated_libcalls", "false")];
    let chosen = [("opt_level", "none"), ("regalloc_algorithm", "backtracking"), ("enable_verifier", "false")];
    for (name, value) in needed.into_iter().chain(chosen) {
        flags.set(name, value).map_err(|e| NoCode::Refused(e.to_string()))?;
    }
    let host = cranelift_native::builder().map_err(NoCode::Host)?;
    host.finish(settings::Flags::new(flags)).map_err(|e| NoCode::Refused(e.to_string()))
}

/// Whether a product and a sum are one instruction here; where not, cranelift would call a function.
fn multiplies_and_adds(isa: &dyn TargetIsa) -> bool {
    let has = |name: &str| isa.isa_flags().iter().any(|flag| flag.name == name && flag.as_bool() == Some(true));
    if cfg!(target_arch = "x86_64") { has("has_avx") && has("has_fma") } else { cfg!(any(target_arch = "aarch64", target_arch = "s390x")) }
}

/// A function of the process that machine code calls.
struct Function {
    name: &'static str,
    arguments: usize,
    address: *const u8,
}

macro_rules! functions {
    ($($name:ident($($x:ident),*) = $value:expr;)*) => {
        $(extern "C" fn $name($($x: f64),*) -> f64 { $value })*
        const FUNCTIONS: &[Function] = &[
            $(Function { name: stringify!($name), arguments: [$(stringify!($x)),*].len(), address: $name as *const u8 },)*
        ];
    };
}

functions! {
    sin(x) = x.sin();
    cos(x) = x.cos();
    tan(x) = x.tan();
    asin(x) = x.asin();
    acos(x) = x.acos();
    atan(x) = x.atan();
    sinh(x) = x.sinh();
    cosh(x) = x.cosh();
    tanh(x) = x.tanh();
    exp(x) = x.exp();
    ln(x) = x.ln();
    atan2(y, x) = y.atan2(x);
    pow(x, y) = x.powf(y);
}

const SIN_COS: &str = "sin_cos";

/// Functions of the process as the module knows them.
struct Imports(FxHashMap<&'static str, FuncId>);

impl Imports {
    /// Makes the functions known to a module that is to be made.
    fn register(builder: &mut JITBuilder) {
        for function in FUNCTIONS {
            builder.symbol(symbol(function.name), function.address);
        }
        builder.symbol(symbol(SIN_COS), sin_cos as *const u8);
    }

    fn declare(module: &mut JITModule) -> Result<Self, NoCode> {
        let number = AbiParam::new(types::F64);
        let mut ids = FxHashMap::default();
        for function in FUNCTIONS {
            let mut signature = module.make_signature();
            signature.params.extend(vec![number; function.arguments]);
            signature.returns.push(number);
            ids.insert(function.name, module.declare_function(&symbol(function.name), Linkage::Import, &signature)?);
        }
        let mut signature = module.make_signature();
        signature.params.extend([number, AbiParam::new(module.target_config().pointer_type())]);
        ids.insert(SIN_COS, module.declare_function(&symbol(SIN_COS), Linkage::Import, &signature)?);
        Ok(Self(ids))
    }
}

/// Names that no library of the process uses.
fn symbol(name: &str) -> String {
    format!("rigwright_{name}")
}

/// Which steps a part has, and which values live in scratch memory.
struct Plan {
    /// Bounds of the parts.
    bounds: Vec<usize>,
    /// Slot in scratch memory of a step's value.
    slot: Vec<Option<u32>>,
    /// sin and cos of one angle: for either step, the other.
    pair: Vec<Option<u32>>,
    /// Products that are computed within the sum that uses them.
    fused: Vec<bool>,
    /// Numbers of scratch memory.
    scratch: usize,
}

impl Plan {
    fn new(tape: &Tape, part: usize, multiplies_and_adds: bool) -> Self {
        let n = tape.steps.len();
        let pair = pairs(&tape.steps);
        // last part that uses each value
        let mut last: Vec<usize> = (0..n).map(|i| i / part).collect();
        for (i, step) in tape.steps.iter().enumerate() {
            for operand in step.operands() {
                last[operand as usize] = last[operand as usize].max(i / part);
            }
        }
        let parts = n.div_ceil(part).max(1);
        let mut slot = vec![None; n];
        let mut scratch = tape.pivots.len() as u32;
        let mut free: Vec<u32> = Vec::new();
        let mut ends: Vec<Vec<u32>> = vec![Vec::new(); parts];
        for k in 0..parts {
            for i in k * part..((k + 1) * part).min(n) {
                if let Some(other) = pair[i] {
                    // neighbours, written together at the first of the two
                    if slot[i].is_none() {
                        slot[i] = Some(scratch);
                        slot[other as usize] = Some(scratch + 1);
                        if matches!(tape.steps[i], Step::Call(F1::Cos, _)) {
                            (slot[i], slot[other as usize]) = (slot[other as usize], slot[i]);
                        }
                        scratch += 2;
                    }
                } else if last[i] > k && !tape.steps[i].is_leaf() {
                    let place = free.pop().unwrap_or_else(|| {
                        scratch += 1;
                        scratch - 1
                    });
                    slot[i] = Some(place);
                    ends[last[i]].push(place);
                }
            }
            free.append(&mut ends[k]);
        }
        let bounds = (0..=parts).map(|k| (k * part).min(n)).collect();
        Self { bounds, slot, pair, fused: if multiplies_and_adds { fused(tape, part) } else { vec![false; n] }, scratch: scratch as usize }
    }
}

/// Products that are used once, by a sum of the same part. Of two products in one sum the later one, since more waits for it.
fn fused(tape: &Tape, part: usize) -> Vec<bool> {
    let mut uses = vec![0_u32; tape.steps.len()];
    let results = tape.results.iter().flatten().chain(&tape.pivots).copied();
    for value in tape.steps.iter().flat_map(|s| s.operands()).chain(results) {
        uses[value as usize] += 1;
    }
    let mut fused = vec![false; tape.steps.len()];
    for (i, step) in tape.steps.iter().enumerate() {
        if let Step::Add(a, b) | Step::Sub(a, b) = *step {
            let fits = |k: u32| matches!(tape.steps[k as usize], Step::Mul(..)) && uses[k as usize] == 1 && k as usize / part == i / part;
            if let Some(product) = [a, b].into_iter().filter(|&k| fits(k)).max() {
                fused[product as usize] = true;
            }
        }
    }
    fused
}

/// For each sine, the cosine of the same angle, and the other way round.
fn pairs(steps: &[Step]) -> Vec<Option<u32>> {
    let mut waiting: FxHashMap<u32, u32> = FxHashMap::default();
    let mut pair = vec![None; steps.len()];
    for (i, step) in steps.iter().enumerate() {
        if let Step::Call(F1::Sin | F1::Cos, angle) = *step {
            match waiting.remove(&angle) {
                Some(other) => {
                    pair[i] = Some(other);
                    pair[other as usize] = Some(i as u32);
                }
                None => {
                    waiting.insert(angle, i as u32);
                }
            }
        }
    }
    pair
}

/// One part under construction.
struct Part<'a, 'f> {
    tape: &'a Tape,
    plan: &'a Plan,
    imports: &'a Imports,
    module: &'a mut JITModule,
    b: FunctionBuilder<'f>,
    /// The first step of the part, and the values of its steps.
    start: usize,
    values: Vec<Option<Value>>,
    pointers: Pointers,
    callees: FxHashMap<&'static str, FuncRef>,
    /// Operations so far, and what was read from memory lately: value, and when it was used last.
    operations: usize,
    lately: FxHashMap<u32, (Value, usize)>,
}

/// What stands in the frame.
struct Pointers {
    frame: Value,
    x: Value,
    u: Value,
    p: Value,
    out: [Value; RESULTS],
    scratch: Value,
}

/// Reads of inputs and of the frame: they do not change during a call.
fn reading() -> MemFlagsData {
    MemFlagsData::trusted().with_readonly().with_can_move()
}

fn offset(place: usize) -> i32 {
    (place * size_of::<f64>()) as i32
}

impl Pointers {
    fn load(b: &mut FunctionBuilder, frame: Value, pointer: Type) -> Self {
        let mut at = |offset: usize| b.ins().load(pointer, reading(), frame, offset as i32);
        Self {
            frame,
            x: at(offset_of!(Frame, x)),
            u: at(offset_of!(Frame, u)),
            p: at(offset_of!(Frame, p)),
            out: std::array::from_fn(|r| at(offset_of!(Frame, out) + r * size_of::<*mut f64>())),
            scratch: at(offset_of!(Frame, scratch)),
        }
    }
}

impl<'a, 'f> Part<'a, 'f> {
    fn new(tape: &'a Tape, plan: &'a Plan, imports: &'a Imports, module: &'a mut JITModule, mut b: FunctionBuilder<'f>) -> Self {
        let block = b.create_block();
        b.append_block_params_for_function_params(block);
        b.switch_to_block(block);
        b.seal_block(block);
        let frame = b.block_params(block)[0];
        let pointers = Pointers::load(&mut b, frame, module.target_config().pointer_type());
        Self {
            tape,
            plan,
            imports,
            module,
            b,
            start: 0,
            values: Vec::new(),
            pointers,
            callees: FxHashMap::default(),
            operations: 0,
            lately: FxHashMap::default(),
        }
    }

    /// The code of the steps in `range`.
    fn build(mut self, range: Range<usize>) {
        self.start = range.start;
        self.values = vec![None; range.len()];
        // where the values of this part leave to: (pointer, place)
        let mut leaving: FxHashMap<usize, Vec<(Value, usize)>> = FxHashMap::default();
        let lists = self.tape.results.iter().zip(self.pointers.out).chain([(&self.tape.pivots, self.pointers.scratch)]);
        for (list, pointer) in lists {
            for (place, &value) in list.iter().enumerate().filter(|(_, value)| range.contains(&(**value as usize))) {
                leaving.entry(value as usize).or_default().push((pointer, place));
            }
        }
        for i in range {
            let step = self.tape.steps[i];
            match (self.plan.pair[i], step) {
                (Some(other), Step::Call(_, angle)) => self.sin_and_cos(i, other as usize, angle),
                _ if step.is_leaf() || self.plan.fused[i] => {}
                _ => {
                    let value = self.operation(step);
                    self.operations += 1;
                    self.values[i - self.start] = Some(value);
                    if let Some(slot) = self.plan.slot[i] {
                        self.b.ins().store(MemFlagsData::trusted(), value, self.pointers.scratch, offset(slot as usize));
                    }
                }
            }
            for &(pointer, place) in leaving.get(&i).into_iter().flatten() {
                let value = self.operand(i as u32);
                self.b.ins().store(MemFlagsData::trusted(), value, pointer, offset(place));
            }
        }
        self.b.ins().return_(&[]);
        self.b.finalize(self.module.target_config());
    }

    /// Writes sine and cosine of an angle to their neighbouring slots, at the first of the two steps.
    fn sin_and_cos(&mut self, i: usize, other: usize, angle: u32) {
        if other < i {
            return;
        }
        let slots = [self.plan.slot[i], self.plan.slot[other]].into_iter().flatten();
        let Some(first) = slots.min() else { return };
        let angle = self.operand(angle);
        let place = self.b.ins().iadd_imm_s(self.pointers.scratch, i64::from(offset(first as usize)));
        self.call(SIN_COS, &[angle, place]);
    }

    fn call(&mut self, name: &'static str, arguments: &[Value]) -> Option<Value> {
        let id = *self.imports.0.get(name)?;
        let callee = *self.callees.entry(name).or_insert_with(|| self.module.declare_func_in_func(id, self.b.func));
        let call = self.b.ins().call(callee, arguments);
        self.b.inst_results(call).first().copied()
    }

    /// The value of a step for use here.
    fn operand(&mut self, i: u32) -> Value {
        if let Some(value) = (i as usize).checked_sub(self.start).and_then(|k| self.values[k]) {
            return value;
        }
        let now = self.operations;
        let value = match self.lately.get(&i) {
            Some(&(value, then)) if now - then <= NEAR => value,
            _ => self.read(i as usize),
        };
        self.lately.insert(i, (value, now));
        value
    }

    /// A number, an input or a value in scratch memory.
    fn read(&mut self, i: usize) -> Value {
        let load = |b: &mut FunctionBuilder, base, place| b.ins().load(types::F64, reading(), base, offset(place));
        match self.tape.steps[i] {
            Step::Number(x) => self.b.ins().f64const(x),
            Step::Input(Input::Time) => self.b.ins().load(types::F64, reading(), self.pointers.frame, offset_of!(Frame, t) as i32),
            Step::Input(Input::X(k)) => load(&mut self.b, self.pointers.x, k),
            Step::Input(Input::U(k)) => load(&mut self.b, self.pointers.u, k),
            Step::Input(Input::P(k)) => load(&mut self.b, self.pointers.p, k),
            // another part's value, or a sine or cosine: the plan gave it a slot
            _ => {
                let slot = self.plan.slot[i].unwrap_or(0);
                self.b.ins().load(types::F64, MemFlagsData::trusted(), self.pointers.scratch, offset(slot as usize))
            }
        }
    }

    fn operation(&mut self, step: Step) -> Value {
        match step {
            // leaves are read where they are used
            Step::Number(_) | Step::Input(_) => self.number(f64::NAN),
            Step::Add(i, j) => match (self.product(i), self.product(j)) {
                (Some((x, y)), _) => {
                    let rest = self.operand(j);
                    self.b.ins().fma(x, y, rest)
                }
                (None, Some((x, y))) => {
                    let rest = self.operand(i);
                    self.b.ins().fma(x, y, rest)
                }
                (None, None) => {
                    let (a, c) = (self.operand(i), self.operand(j));
                    self.b.ins().fadd(a, c)
                }
            },
            Step::Sub(i, j) => match (self.product(i), self.product(j)) {
                (Some((x, y)), _) => {
                    let rest = self.operand(j);
                    let minus = self.b.ins().fneg(rest);
                    self.b.ins().fma(x, y, minus)
                }
                (None, Some((x, y))) => {
                    let rest = self.operand(i);
                    let minus = self.b.ins().fneg(x);
                    self.b.ins().fma(minus, y, rest)
                }
                (None, None) => {
                    let (a, c) = (self.operand(i), self.operand(j));
                    self.b.ins().fsub(a, c)
                }
            },
            Step::Mul(i, j) => {
                let (a, c) = (self.operand(i), self.operand(j));
                self.b.ins().fmul(a, c)
            }
            Step::Div(i, j) => {
                let (a, c) = (self.operand(i), self.operand(j));
                self.b.ins().fdiv(a, c)
            }
            Step::Neg(i) => {
                let a = self.operand(i);
                self.b.ins().fneg(a)
            }
            Step::Powi(i, n) => {
                let a = self.operand(i);
                self.power(a, n)
            }
            Step::Call(f, i) => {
                let a = self.operand(i);
                self.function(f, a)
            }
            Step::Call2(f, i, j) => {
                let (a, c) = (self.operand(i), self.operand(j));
                self.function2(f, a, c)
            }
        }
    }

    /// Factors of a product that is computed within its sum.
    fn product(&mut self, i: u32) -> Option<(Value, Value)> {
        match self.tape.steps[i as usize] {
            Step::Mul(x, y) if self.plan.fused[i as usize] => Some((self.operand(x), self.operand(y))),
            _ => None,
        }
    }

    fn number(&mut self, x: f64) -> Value {
        self.b.ins().f64const(x)
    }

    /// a^n by repeated squaring, as `f64::powi`.
    fn power(&mut self, a: Value, n: i32) -> Value {
        let one = self.number(1.0);
        let (mut total, mut square, mut left) = (None, a, n.unsigned_abs());
        while left > 0 {
            if left & 1 == 1 {
                total = Some(total.map_or(square, |t| self.b.ins().fmul(t, square)));
            }
            left >>= 1;
            if left > 0 {
                square = self.b.ins().fmul(square, square);
            }
        }
        let total = total.unwrap_or(one);
        if n < 0 { self.b.ins().fdiv(one, total) } else { total }
    }

    fn function(&mut self, f: F1, a: Value) -> Value {
        let name = match f {
            F1::Sin => "sin",
            F1::Cos => "cos",
            F1::Tan => "tan",
            F1::Asin => "asin",
            F1::Acos => "acos",
            F1::Atan => "atan",
            F1::Sinh => "sinh",
            F1::Cosh => "cosh",
            F1::Tanh | F1::SmoothSign => "tanh",
            F1::Exp => "exp",
            F1::Ln => "ln",
            F1::Sqrt => return self.b.ins().sqrt(a),
            F1::Abs => return self.b.ins().fabs(a),
            F1::Sign => {
                let (plus, minus) = (self.number(1.0), self.number(-1.0));
                let below = self.choose(FloatCC::LessThan, a, minus);
                return self.choose_or(FloatCC::GreaterThan, a, plus, below);
            }
            F1::Step => {
                let one = self.number(1.0);
                return self.choose(FloatCC::GreaterThan, a, one);
            }
        };
        self.call(name, &[a]).unwrap_or(a)
    }

    /// `value` where a compares to zero, else zero.
    fn choose(&mut self, with_zero: FloatCC, a: Value, value: Value) -> Value {
        let zero = self.number(0.0);
        self.choose_or(with_zero, a, value, zero)
    }

    /// `value` where a compares to zero, else `other`.
    fn choose_or(&mut self, with_zero: FloatCC, a: Value, value: Value, other: Value) -> Value {
        let zero = self.number(0.0);
        let holds = self.b.ins().fcmp(with_zero, a, zero);
        self.b.ins().select(holds, value, other)
    }

    fn function2(&mut self, f: F2, a: Value, c: Value) -> Value {
        let compare = match f {
            F2::Atan2 => return self.call("atan2", &[a, c]).unwrap_or(a),
            F2::Pow => return self.call("pow", &[a, c]).unwrap_or(a),
            F2::Min => FloatCC::LessThan,
            F2::Max => FloatCC::GreaterThan,
        };
        // as `f64::min`: where one of the two is not a number, the other
        let takes_a = self.b.ins().fcmp(compare, a, c);
        let only_a = self.b.ins().fcmp(FloatCC::Unordered, c, c);
        let takes_a = self.b.ins().bor(takes_a, only_a);
        self.b.ins().select(takes_a, a, c)
    }
}
