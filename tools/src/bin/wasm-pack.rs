//! `wasm-pack` without its self-installer and its question to the network for a newer version.

use clap::Parser;

fn main() {
    env_logger::init();
    let args = wasm_pack::Cli::parse();
    wasm_pack::PBAR.set_log_level(args.log_level);
    wasm_pack::PBAR.set_quiet(args.quiet);
    if let Err(error) = wasm_pack::command::run_wasm_pack(args.cmd) {
        eprintln!("error: {error:#}"); // without the backtrace that `Debug` adds
        std::process::exit(1);
    }
}
