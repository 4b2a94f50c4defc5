# R's own figures for readings.csv: lm, summary.lm, extractAIC and step, printed as JSON with base R alone.
#   Rscript reference.R readings.csv > r_reference.json
#
# The powers enter as they are, up to 540^7. lm drops a column whose part outside the earlier ones is smaller than
# tol = 1e-7 of the column; that is a ratio, so the scale of the position does not matter to it. For x^7 beside x ... x^6 on
# positions from 0 it is near 3e-4, and nothing is dropped. "rank" and "scaled" (x / 540) below prove it. Only from about
# x^13 on would lm lose columns here, scaled or not.

path <- commandArgs(trailingOnly = TRUE)[1]
readings <- read.csv(path)

number <- function(v) ifelse(is.finite(v), sprintf("%.17g", v), "null")
array <- function(v) paste0("[", paste(v, collapse = ", "), "]")
object <- function(...) {
  parts <- list(...)
  paste0("{", paste(sprintf("\"%s\": %s", names(parts), unlist(parts)), collapse = ", "), "}")
}

powers_of <- function(fit) sub("^X", "", names(coef(fit)))

model <- function(fit) {
  s <- summary(fit)
  f <- s$fstatistic
  object(
    powers = array(powers_of(fit)),
    coefficients = array(number(coef(fit))),
    u = array(number(s$coefficients[, "Std. Error"])),
    t_values = array(number(s$coefficients[, "t value"])),
    p_values = array(number(s$coefficients[, "Pr(>|t|)"])),
    r_squared = number(s$r.squared),
    adjusted_r_squared = number(s$adj.r.squared),
    residual_standard_error = number(s$sigma),
    residual_df = s$df[2],
    rss = number(deviance(fit)),
    aic = number(extractAIC(fit)[2]),
    f_statistic = number(f[["value"]]),
    f_p_value = number(pf(f[["value"]], f[["numdf"]], f[["dendf"]], lower.tail = FALSE)),
    rank = fit$rank
  )
}

case <- function(values, weights, order, scale = 1) {
  terms <- paste0("X", 1:order)
  data <- as.data.frame(lapply(setNames(1:order, terms), function(k) (readings$position_mm / scale)^k))
  data$Y <- values
  data$W <- weights
  formula <- reformulate(terms, "Y", intercept = FALSE)
  full <- lm(formula, data, weights = W)
  environment(formula) <- environment()
  both <- step(full, direction = "both", trace = 0)
  default <- step(full, trace = 0) # R without a scope and a direction goes backward only
  nested <- lapply(1:order, function(p) lm(reformulate(terms[1:p], "Y", intercept = FALSE), data, weights = W))
  object(
    order = order,
    scale = scale,
    mean_squares = array(number(sapply(nested, function(fit) summary(fit)$sigma^2))),
    before = model(full),
    after = model(both),
    changes = array(sprintf("\"%s\"", gsub("[ X]", "", both$anova$Step[-1]))),
    step_aic = array(number(both$anova$AIC)),
    default_powers = array(powers_of(default))
  )
}

ones <- rep(1, nrow(readings))
cat(object(
  r = sprintf("\"%s.%s\"", R.version$major, R.version$minor),
  drawn = case(readings$drawn_urad, ones, 7),
  drawn_order_6 = case(readings$drawn_urad, ones, 6),
  drawn_scaled = case(readings$drawn_urad, ones, 7, 540),
  drawn_weighted = case(readings$drawn_urad, 1 / readings$u_urad^2, 7),
  implied = case(readings$implied_urad, ones, 7),
  walk = case(readings$walk_urad, ones, 7)
), "\n", sep = "")
