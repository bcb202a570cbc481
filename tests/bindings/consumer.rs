//! Asks the library about a view without a device, as tests/abi/consumer.c does, and makes an error.
use agaa_sys::*;
use std::cell::RefCell;
use std::ffi::{CStr, CString};
use std::os::raw::{c_char, c_void};
use std::ptr::{null, null_mut};

type Messages = RefCell<Vec<(u32, AgaaResult, String)>>;

/// `text` must be null-terminated and outlive the returned reference.
unsafe fn text<'a>(text: *const c_char) -> &'a str {
    CStr::from_ptr(text).to_str().unwrap()
}

unsafe extern "C" fn keep(
    user: *mut c_void,
    severity: u32,
    code: AgaaResult,
    message: *const c_char,
) {
    let messages = &*(user as *const Messages);
    messages
        .borrow_mut()
        .push((severity, code, text(message).to_string()));
}

unsafe fn techniques() -> Vec<&'static str> {
    let mut count = 0;
    assert_eq!(
        agaaGetNames(AGAA_NAMES_TECHNIQUES, &mut count, null_mut()),
        AGAA_OK
    );
    let mut names = vec![null(); count as usize];
    assert_eq!(
        agaaGetNames(AGAA_NAMES_TECHNIQUES, &mut count, names.as_mut_ptr()),
        AGAA_OK
    );
    names.into_iter().map(|name| text(name)).collect()
}

unsafe fn prices(view: &AgaaViewDesc, log: &AgaaLog) -> Vec<AgaaPrice> {
    let mut count = 0;
    assert_eq!(
        agaaQueryPrices(view, null(), log, &mut count, null_mut()),
        AGAA_OK
    );
    let mut prices = vec![AgaaPrice::default(); count as usize];
    assert_eq!(
        agaaQueryPrices(view, null(), log, &mut count, prices.as_mut_ptr()),
        AGAA_OK
    );
    prices
}

unsafe fn run() {
    assert_eq!(agaaGetVersion(), AGAA_HEADER_VERSION);
    assert!(techniques().contains(&"simple_complex"));

    let messages = Messages::default();
    let mut log = AgaaLog::default();
    log.callback = Some(keep);
    log.user = &messages as *const Messages as *mut c_void;

    let mut layout = AgaaLayout::default();
    let name = CString::new("paper16").unwrap();
    assert_eq!(agaaGetBuiltinLayout(name.as_ptr(), &mut layout), AGAA_OK);
    let mut config = AgaaConfig::default();
    assert_eq!(
        (text(config.technique), config.samples, config.aggregates),
        ("agaa", 8, 2)
    );
    config.layout = &layout;
    config.visibilityTier = AGAA_TIER_NATIVE;
    config.generationTier = AGAA_TIER_NV_MIXED_SAMPLES;
    let mut facts = AgaaSceneFacts::default();
    facts.maxLights = 1; // more lights have masks for each tile of pixels
    let mut view = AgaaViewDesc::default();
    view.width = 640;
    view.height = 360;
    view.config = &config;
    view.facts = &facts;

    let mut report = AgaaMemoryReport::default();
    let result = agaaQueryMemory(&view, null(), &log, &mut report, null_mut(), null_mut());
    println!(
        "{}: {:.1} bytes per pixel",
        text(agaaResultName(result)),
        report.bytesPerPixel
    );
    assert_eq!((result, report.bytesPerPixel), (AGAA_OK, 81.0));

    let mut standard = AgaaConfig::default();
    view.config = &standard;
    let lit = prices(&view, &log)
        .into_iter()
        .find(|price| text(price.name) == "lit-aggregates");
    assert_eq!(lit.unwrap().geometryPasses, -1); // one geometry pass in place of two
    assert!(messages.borrow().is_empty());

    standard.flags = 1 << 40;
    view.config = &standard;
    let result = agaaQueryMemory(&view, null(), &log, &mut report, null_mut(), null_mut());
    assert_eq!(result, AGAA_ERROR_OUT_OF_RANGE);
    let messages = messages.borrow();
    assert_eq!(messages.len(), 1);
    let (severity, code, message) = &messages[0];
    println!("{message}");
    assert_eq!(
        (*severity, *code),
        (AGAA_SEVERITY_ERROR, AGAA_ERROR_OUT_OF_RANGE)
    );
    assert!(message.starts_with("agaaQueryMemory") && message.contains("0x10000000000"));
}

fn main() {
    unsafe { run() }
}
