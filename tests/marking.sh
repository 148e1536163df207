#!/usr/bin/env bash
# Tries the teachers' recipe for marking a branch, word for word as the page has it, on a branch that is right, on
# some that cheat by their configuration, and on one that never ends.
set -euo pipefail
root=$(cd "$(dirname "$0")/.." && pwd)
page=${1:-$root/book/src/teachers.md}
work=$root/target/marking
rm -rf "$work"/{class,marking,build-script}
mkdir -p "$work/class"
# The crates of others are the same for everybody, and are built once.
export CARGO_TARGET_DIR=$root/target

# The commands of the page: those that are given once, up to the first `cargo test`, and those for each branch.
commands=$(sed -n '/^\*\*To mark a branch/,/^\*\*Pictures/s/^\$ //p' "$page")
once=$(sed '/^cargo test/q' <<<"$commands")
each=$(sed '1,/^cargo test/d' <<<"$commands")

fail() {
    echo "FAILED: $*" >&2
    cat "$work/log" >&2
    exit 1
}

# The class's repository: what stands here, on the branch main.
tar -C "$root" --exclude=./target --exclude=./.git --exclude=./book/book -c . | tar -C "$work/class" -x
cd "$work/class"
export GIT_AUTHOR_NAME=a GIT_AUTHOR_EMAIL=a GIT_COMMITTER_NAME=a GIT_COMMITTER_EMAIL=a
git init --quiet --initial-branch main
git add --all
git commit --quiet --message ours
reflect=chapters/06-reflection/src/lib.rs

# Makes a branch of main, on which a function changes files.
branch() {
    git switch --quiet --create "$1" main
    "$2"
    git add --all --force
    git commit --quiet --message theirs
    git switch --quiet main
}
wrong() { sed -i '/^pub fn reflect(/a\    return incident;' $reflect; }
right() {
    sed -i '/^pub fn reflect(/a\    // The same in other words.' $reflect
    # Of no use to them: it is not ours.
    printf '[toolchain]\nchannel = "0.1"\n' >rust-toolchain.toml
}
force_pass() { wrong; sed -i '/^\[env\]/a INSTA_FORCE_PASS = "1"' .cargo/config.toml; }
runner() { wrong; printf '[target."cfg(all())"]\nrunner = "true"\n' >.cargo/config.toml; }
everything() {
    wrong
    echo 'fn main() { std::fs::write("'"$work"'/build-script", "").unwrap() }' >chapters/06-reflection/build.rs
    printf 'behavior:\n  force_pass: true\n' | tee .insta.yaml >insta.yaml
    mkdir .config && cp insta.yaml .config/
    echo '#[test] fn every_picture_is_the_one_in_the_book() {}' >tests/reflection/main.rs
    sed -i '/^insta = /d' Cargo.toml
    printf '[build]\nrustflags = ["--cfg", "cheating"]\n' >.cargo/config
}
endless() { sed -i '/^pub fn reflect(/a\    loop { std::hint::spin_loop() }' $reflect; }
for name in right force_pass runner everything endless; do
    branch "$name" "$name"
done

# Marks a branch; sets `code` to the exit code of the tests. What is said is in the log.
mark() {
    code=0
    while read -r command; do
        command=${command//their-branch/$1}
        case $command in
        timeout*)
            # Ten minutes are a teacher's patience, building included. Here it is seconds, without.
            cargo test --quiet --no-run --test reflection >"$work/log" 2>&1 || fail "$1 does not build"
            eval "${command/10m/30s}" >"$work/log" 2>&1 || code=$? ;;
        *cargo*) eval "$command" >"$work/log" 2>&1 || code=$? ;;
        *) eval "$command" >/dev/null 2>&1 || fail "$command" ;;
        esac
    done <<<"$each"
}

while read -r command; do
    eval "$command" >"$work/log" 2>&1 || fail "$command"
done <<<"$once"
tests=$(grep -c '\.\.\. ok$' "$work/log")

mark right
[ $code = 0 ] && grep -q "^test result: ok. $tests passed" "$work/log" || fail "what is right does not pass"
for name in force_pass runner everything; do
    mark "$name"
    [ $code = 101 ] && grep -q '^test result: FAILED' "$work/log" || fail "$name passes"
done
[ ! -e "$work/build-script" ] || fail "a build script of theirs has run"
mark endless
[ $code = 124 ] || fail "an endless loop ends with $code"
echo "marking: $tests tests; what is right passes, 3 branches that cheat do not, an endless loop is ended"
